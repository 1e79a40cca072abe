#include "accel/clearance_grid.h"
#include "base/parallel.h"
#include <array>
#include <cmath>
#include <optional>

namespace nacre::accel {
namespace {

constexpr double band = clearance_band;

/// A triangle or part of one, in a grid. In double: with the floats it is made of, even the thinnest leaves digits
/// enough.
using Corners = std::array<Vec3, 3>;

/// Distance to a piece of the surface.
class Distance {
  public:
    explicit Distance(const Corners &vertex) : vertex(vertex) {
        for (std::size_t k = 0; k < 3; k++) {
            edge[k] = vertex[(k + 1) % 3] - vertex[k];
            inverse[k] = edge[k].squaredNorm() > 0 ? 1 / edge[k].squaredNorm() : 0;
        }
        normal = edge[0].cross(edge[1]).normalized();
        for (std::size_t k = 0; k < 3; k++) inwards[k] = normal.cross(edge[k]);
    }

    /// Squared, or `most` where it is more. Above the triangle it is the distance to its plane, else that to its
    /// nearest edge. Where rounding mistakes one for the other, they differ by as little.
    double squared(const Vec3 &p, double most) const {
        const std::array<Vec3, 3> from{p - vertex[0], p - vertex[1], p - vertex[2]};
        const double height = normal.dot(from[0]);
        if (height * height >= most) return most;
        if (from[0].dot(inwards[0]) >= 0 && from[1].dot(inwards[1]) >= 0 && from[2].dot(inwards[2]) >= 0)
            return height * height;
        for (std::size_t k = 0; k < 3; k++) {
            const double t = std::clamp(from[k].dot(edge[k]) * inverse[k], 0.0, 1.0);
            most = std::min(most, (from[k] - t * edge[k]).squaredNorm());
        }
        return most;
    }

  private:
    const Corners &vertex;
    std::array<Vec3, 3> edge, inwards;
    std::array<double, 3> inverse; // of the edges' squared lengths
    Vec3 normal;
};

/// A block of rows of cells, all that one thread has to do with at a time.
class Tile {
  public:
    static constexpr int side = 8;

    Tile(const ClearanceGrid &grid, int column, int layer, std::vector<float> &distances)
        : grid(grid), lower(0, column * side, layer * side),
          upper(grid.size.x(), std::min((column + 1) * side, grid.size.y()),
                std::min((layer + 1) * side, grid.size.z())),
          distances(distances) {}

    /// Lowers the distances of the tile's cells to those from a triangle. Long ones are halved along the longest edge:
    /// the box about one that lies askew is mostly empty, and so is the sphere about a thin one.
    void add(const Corners &corners) {
        const Vec3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
        const Vec3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
        // Cells whose centres can be within the band.
        const auto first = (low.array() - (band + 0.5)).ceil().matrix().cast<int>().cwiseMax(lower).eval();
        const auto end = (high.array() + (band + 0.5)).floor().matrix().cast<int>().cwiseMin(upper).eval();
        if ((first.array() >= end.array()).any()) return;

        const Vec3 centre = 0.5 * (low + high);
        const double radius =
            std::sqrt(std::max({(corners[0] - centre).squaredNorm(), (corners[1] - centre).squaredNorm(),
                                (corners[2] - centre).squaredNorm()}));
        if (radius > longest) return halve(corners);
        // Made when it is first needed: where triangles are many to a cell, most are farther than one before.
        std::optional<Distance> distance;
        for (int z = first.z(); z < end.z(); z++)
            for (int y = first.y(); y < end.y(); y++) {
                const double dy = y + 0.5 - centre.y(), dz = z + 0.5 - centre.z(), aside2 = dy * dy + dz * dz;
                if (aside2 > (radius + band) * (radius + band)) continue;
                float *row = distances.data() + grid.row(y, z);
                for (int x = first.x(); x < end.x(); x++) {
                    const double dx = x + 0.5 - centre.x(), known = row[x], reach = known + radius;
                    if (dx * dx + aside2 >= reach * reach) continue;
                    if (!distance) distance.emplace(corners);
                    const double squared = distance->squared({x + 0.5, y + 0.5, z + 0.5}, known * known);
                    if (squared < known * known) row[x] = float(std::sqrt(squared));
                }
            }
    }

  private:
    static constexpr double longest = 3; // radius in cells

    void halve(const Corners &corners) {
        std::size_t k = 0;
        double most = 0;
        for (std::size_t i = 0; i < 3; i++) {
            const double length = (corners[(i + 1) % 3] - corners[i]).squaredNorm();
            if (length > most) k = i;
            most = std::max(most, length);
        }
        const Vec3 &a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3], middle = 0.5 * (a + b);
        add({a, middle, c});
        add({middle, b, c});
    }

    const ClearanceGrid &grid;
    const Eigen::Vector3i lower, upper; // cells
    std::vector<float> &distances;
};

/// Which triangles come near which tile.
class Members {
  public:
    Members(const ClearanceGrid &grid, std::span<const Triangle> triangles)
        : columns((grid.size.y() + Tile::side - 1) / Tile::side), layers((grid.size.z() + Tile::side - 1) / Tile::side),
          first(std::size_t(columns * layers) + 1) {
        // By counting and then filling.
        visit(grid, triangles, [&](std::size_t tile, std::uint32_t) { first[tile + 1]++; });
        for (std::size_t tile = 1; tile < first.size(); tile++) first[tile] += first[tile - 1];
        members.resize(first.back());
        std::vector<std::size_t> next(first.begin(), first.end() - 1);
        visit(grid, triangles, [&](std::size_t tile, std::uint32_t i) { members[next[tile]++] = i; });
    }

    std::size_t tiles() const { return first.size() - 1; }
    int column(std::size_t tile) const { return int(tile % std::size_t(columns)); }
    int layer(std::size_t tile) const { return int(tile / std::size_t(columns)); }
    std::span<const std::uint32_t> of(std::size_t tile) const {
        return {members.data() + first[tile], first[tile + 1] - first[tile]};
    }

  private:
    template <typename F> void visit(const ClearanceGrid &grid, std::span<const Triangle> triangles, const F &f) const {
        const auto tile = [](double at, int tiles) {
            return std::clamp(int(std::floor(at / Tile::side)), 0, tiles - 1);
        };
        for (std::size_t i = 0; i < triangles.size(); i++) {
            const auto &v = triangles[i].v;
            const Vec3 low = grid.inside(v[0].cwiseMin(v[1]).cwiseMin(v[2]));
            const Vec3 high = grid.inside(v[0].cwiseMax(v[1]).cwiseMax(v[2]));
            const int y1 = tile(high.y() + band, columns), z1 = tile(high.z() + band, layers);
            for (int z = tile(low.z() - band, layers); z <= z1; z++)
                for (int y = tile(low.y() - band, columns); y <= y1; y++)
                    f(std::size_t(z * columns + y), std::uint32_t(i));
        }
    }

    const int columns, layers;
    std::vector<std::size_t> first; // of each tile, and the end
    std::vector<std::uint32_t> members;
};

} // namespace

std::vector<float> near_distances(const ClearanceGrid &grid, std::span<const Triangle> triangles) {
    // A little more than the band: its own end must count as near.
    std::vector<float> distances(grid.cells(), float(band * 1.000001));
    const Members members(grid, triangles);
    parallel_for(members.tiles(), [&](std::size_t i) {
        Tile tile(grid, members.column(i), members.layer(i), distances);
        for (const std::uint32_t member : members.of(i)) {
            const auto &v = triangles[member].v;
            tile.add({grid.inside(v[0]), grid.inside(v[1]), grid.inside(v[2])});
        }
    });
    return distances;
}

} // namespace nacre::accel
