#include "albedo/half_space.h"
#include "albedo/table_axes.h"
#include "base/parallel.h"
#include <bit>
#include <cstring>
#include <mutex>
#include <stdexcept>

namespace nacre::albedo {
namespace {

using namespace shared;

constexpr std::string_view title = "nacre albedo table 1\n";
static_assert(std::endian::native == std::endian::little, "the table's file is little-endian");

} // namespace

std::vector<float> build_table(const std::function<void(double)> &progress) {
    std::vector<float> table(table_size);
    constexpr std::size_t media = std::size_t(2) * table_anisotropies * table_bleeds;
    std::mutex guard;
    std::size_t done = 0;
    parallel_for(media, [&](std::size_t k) {
        const auto law = k % 2 ? FLIGHT_RECIPROCAL : FLIGHT_RENEWAL;
        const int i = int(k / 2) % table_anisotropies, j = int(k / 2) / table_anisotropies;
        const double bleed = bleed_at(j), power = table_power(bleed, law);
        const HalfSpace medium(anisotropy_at(i), bleed, law);
        for (const Entry entry : {ENTRY_LAMBERT, ENTRY_UNIFORM})
            for (int c = 0; c < table_colors; ++c)
                table[table_index(law, entry, i, j) + std::size_t(c)] =
                    float(std::pow(medium.similarity(color_at(c), entry), 1 / power));
        const std::lock_guard lock(guard);
        progress(double(++done) / double(media));
    });
    return table;
}

std::string table_file(std::span<const float> table) {
    std::string file(title);
    file.append(reinterpret_cast<const char *>(table.data()), table.size_bytes());
    return file;
}

std::vector<float> read_table(std::string_view file) {
    if (!file.starts_with(title) || file.size() != title.size() + table_size * sizeof(float))
        throw std::runtime_error("not an albedo table of this version");
    std::vector<float> table(table_size);
    std::memcpy(table.data(), file.data() + title.size(), table_size * sizeof(float));
    return table;
}

} // namespace nacre::albedo
