#include "accel/clearance.h"
#include "accel/clearance_grid.h"
#include "base/parallel.h"
#include <cmath>

namespace nacre::accel {
namespace {

constexpr int brick = CLEARANCE_BRICK;
static_assert(sizeof(shared::Clearance) == 48 && brick * brick * brick == CLEARANCE_BRICK_BYTES);

/// Bricks along each axis for cells of `edge`.
Vec3 bricks_for(const Vec3 &extent, double edge) {
    return (extent / (brick * edge)).array().ceil().cwiseMax(1.0).matrix();
}

/// The grid around `box` whose cells are at least `wanted` and take at most `budget` bytes, one each. A budget without
/// room for a brick gives a grid without cells.
ClearanceGrid fit_grid(const Eigen::AlignedBox3f &box, float wanted, std::size_t budget) {
    ClearanceGrid grid{box.min(), wanted, {0, 0, 0}};
    // A kernel counts words and cells along an axis in ints and floats.
    const double bricks = double(std::min(budget, std::size_t(1) << 31) / CLEARANCE_BRICK_BYTES);
    const Vec3 lower = box.min().cast<double>(), extent = box.max().cast<double>() - lower;
    if (bricks < 1 || !(extent.maxCoeff() > 0)) return grid;
    // One brick holds everything with the largest edge, and no budget has more bricks than the least in a row.
    double edge = std::max(double(wanted), extent.maxCoeff() / (brick * bricks));
    while (bricks_for(extent, edge).prod() > bricks) edge *= 1.01;
    edge *= 1 + 1e-6; // so that rounding to float leaves the box inside
    const Vec3 count = bricks_for(extent, edge);
    grid.edge = float(edge);
    grid.size = (count * brick).cast<int>();
    // Centred on the box.
    grid.corner = (lower + 0.5 * extent - 0.5 * brick * edge * count).cast<float>();
    return grid;
}

/// Codes of a brick's cells, rounded down: unit * code^2 <= distance in the kernel's arithmetic.
void encode(const ClearanceGrid &grid, const std::vector<float> &distances, float unit, std::size_t index,
            std::uint8_t *codes) {
    const std::size_t columns = std::size_t(grid.size.x() / brick), rows = std::size_t(grid.size.y() / brick);
    const int x = int(index % columns) * brick, y = int(index / columns % rows) * brick;
    const int z = int(index / columns / rows) * brick;
    for (int k = 0; k < brick; k++)
        for (int j = 0; j < brick; j++)
            for (int i = 0; i < brick; i++) {
                const float distance = distances[grid.row(y + j, z + k) + std::size_t(x + i)];
                float code = std::min(255.0f, std::floor(std::sqrt(distance / unit)));
                if (code * code * unit > distance) code -= 1;
                *codes++ = std::uint8_t(code);
            }
}

} // namespace

ClearanceField build_clearance(std::span<const Triangle> triangles, float wanted_cell, std::size_t budget) {
    ClearanceField field;
    std::vector<Triangle> solid;
    solid.reserve(triangles.size());
    Eigen::AlignedBox3f box;
    for (const Triangle &triangle : triangles) {
        if (!can_be_hit(triangle)) continue;
        solid.push_back(triangle);
        for (const Vec3f &v : triangle.v) box.extend(v);
    }
    if (solid.empty() || !(wanted_cell > 0) || !std::isfinite(wanted_cell)) return field;
    const ClearanceGrid grid = fit_grid(box, wanted_cell, budget);
    if (grid.cells() == 0) return field;

    std::vector<float> distances = near_distances(grid, solid);
    extend_distances(grid, distances);
    // From cells to the kernels' units, less the rounding on the way here: doubles to float, square roots, this
    // product.
    const float scale = grid.edge * (1 - 1e-6f);
    const std::size_t layer = grid.row(0, 1);
    std::vector<float> largest(std::size_t(grid.size.z()));
    parallel_for(largest.size(), [&](std::size_t z) {
        float most = 0;
        for (std::size_t i = z * layer; i < (z + 1) * layer; i++) most = std::max(most, distances[i] *= scale);
        largest[z] = most;
    });
    const float unit = *std::max_element(largest.begin(), largest.end()) / (255 * 255);
    if (!(unit > 0)) return field;

    field.bricks.resize(grid.cells());
    const std::size_t batch = layer / (brick * brick); // bricks of a layer
    parallel_for(largest.size() / brick, [&](std::size_t z) {
        for (std::size_t b = z * batch; b < (z + 1) * batch; b++)
            encode(grid, distances, unit, b, field.bricks.data() + b * CLEARANCE_BRICK_BYTES);
    });

    // A coordinate rounds by at most half of 2^-23 of the largest there is, corners of cells as well as points; a
    // look-up meets three axes of a few such errors each, and the caller's points are rounded too.
    const float largest_coordinate =
        std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()) + grid.edge * brick;
    field.info.corner = {grid.corner.x(), grid.corner.y(), grid.corner.z(), grid.edge};
    field.info.inverse_edge = 1 / grid.edge;
    field.info.unit = unit;
    field.info.rounding = 16 * 0x1p-24f * largest_coordinate;
    field.info.bricks_x = std::uint32_t(grid.size.x() / brick);
    field.info.bricks_y = std::uint32_t(grid.size.y() / brick);
    field.info.bricks_z = std::uint32_t(grid.size.z() / brick);
    return field;
}

} // namespace nacre::accel
