#include "accel/clearance_grid.h"
#include "base/parallel.h"
#include <algorithm>
#include <cmath>

// A Euclidean distance transform in one pass per axis (Felzenszwalb, Huttenlocher 2012, "Distance Transforms of Sampled
// Functions"), of the gap between a cell's centre and the nearest box of a cell that the surface may pass through.
// Along an axis that gap is d - 1/2 cells for boxes d cells away, so that the squares of twice the gap are whole
// numbers.

namespace nacre::accel {
namespace {

constexpr float none = 1e30f;
constexpr int strip = 64; // cells that go through a pass side by side: few, as the farthest of them decides how long

float gap2(int d) {
    const float twice = float(std::max(2 * d - 1, 0));
    return twice * twice;
}

/// Along x, from the distances: the surface may pass through a cell whose centre is at most half a diagonal away.
void along_row(const float *near, float *far, int size) {
    constexpr float diagonal = 0.86603f;
    int since = size;
    for (int x = 0; x < size; x++) {
        since = near[x] <= diagonal ? 0 : since + 1;
        far[x] = since < size ? gap2(since) : none;
    }
    since = size;
    for (int x = size; x-- > 0;) {
        since = near[x] <= diagonal ? 0 : since + 1;
        if (since < size) far[x] = std::min(far[x], gap2(since));
    }
}

/// Across rows: far[i][x] becomes the least of far[j][x] + gap2(|i - j|), for `size` rows `stride` apart.
void across_rows(float *far, int size, std::size_t stride, int width, std::vector<float> &copy) {
    copy.resize(std::size_t(size) * strip);
    for (int i = 0; i < size; i++)
        for (int x = 0; x < strip; x++)
            copy[std::size_t(i * strip + x)] = x < width ? far[std::size_t(i) * stride + std::size_t(x)] : 0;
    for (int i = 0; i < size; i++) {
        float best[strip];
        std::copy_n(copy.data() + i * strip, strip, best);
        const auto meet = [&](int j, float add) {
            const float *row = copy.data() + j * strip;
            for (int x = 0; x < strip; x++) best[x] = row[x] + add < best[x] ? row[x] + add : best[x];
        };
        for (int d = 1; d < size; d++) {
            const float add = gap2(d);
            int open = 0;
            for (int x = 0; x < strip; x++) open |= best[x] > add;
            if (!open) break;
            if (i >= d) meet(i - d, add);
            if (i + d < size) meet(i + d, add);
        }
        std::copy_n(best, width, far + std::size_t(i) * stride);
    }
}

} // namespace

void extend_distances(const ClearanceGrid &grid, std::vector<float> &near) {
    const int nx = grid.size.x(), ny = grid.size.y(), nz = grid.size.z();
    std::vector<float> far(grid.cells());
    parallel_for(std::size_t(nz), [&](std::size_t z) {
        std::vector<float> copy;
        for (int y = 0; y < ny; y++) along_row(&near[grid.row(y, int(z))], &far[grid.row(y, int(z))], nx);
        for (int x = 0; x < nx; x += strip)
            across_rows(&far[grid.row(0, int(z)) + std::size_t(x)], ny, std::size_t(nx), std::min(strip, nx - x), copy);
    });
    parallel_for(std::size_t(ny), [&](std::size_t y) {
        std::vector<float> copy;
        const std::size_t layer = grid.row(0, 1);
        for (int x = 0; x < nx; x += strip)
            across_rows(&far[grid.row(int(y), 0) + std::size_t(x)], nz, layer, std::min(strip, nx - x), copy);
        for (int z = 0; z < nz; z++)
            for (std::size_t i = grid.row(int(y), z), end = i + std::size_t(nx); i < end; i++)
                if (near[i] > float(clearance_band))
                    near[i] = std::max(float(clearance_band), 0.5f * std::sqrt(far[i]));
    });
}

} // namespace nacre::accel
