#include "sheet/contact.h"
#include "sheet/text.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace nacre::sheet {
namespace {

// Linear RGB.
constexpr float background = 0.015f;
using Color = std::array<float, 3>;
constexpr Color bright{0.9f, 0.9f, 0.9f}, soft{0.45f, 0.45f, 0.45f};

// Pixels. A line takes 1.4 times its size, and its baseline is one size below its top.
constexpr int title_size = 20, label_size = 16, small_size = 13;
constexpr int advance(int size) { return size * 7 / 5; }

struct Line {
    std::string text;
    int size;
    Color color;
};

/// Joins words with commas into lines no wider than `width` where that can be.
std::vector<std::string> wrap(const std::vector<std::string> &words, int size, int width) {
    std::vector<std::string> lines;
    for (const std::string &word : words) {
        const std::string longer = lines.empty() ? word : lines.back() + ", " + word;
        if (!lines.empty() && text_width(longer, size) <= width)
            lines.back() = longer;
        else
            lines.push_back(word);
    }
    return lines;
}

std::vector<Line> caption(const Tile &tile) {
    std::vector<Line> lines{{tile.label, label_size, bright}};
    for (const std::string &text : wrap(tile.settings, small_size, tile.picture.width))
        lines.push_back({text, small_size, soft});
    lines.push_back({tile.cost, small_size, soft});
    return lines;
}

int width_of(const std::vector<Line> &lines) {
    int width = 0;
    for (const Line &line : lines) width = std::max(width, text_width(line.text, line.size));
    return width;
}

int height_of(const std::vector<Line> &lines) {
    int height = 0;
    for (const Line &line : lines) height += advance(line.size);
    return height;
}

void draw_lines(io::Picture &sheet, int x, int y, const std::vector<Line> &lines) {
    for (const Line &line : lines) {
        draw_text(sheet, x, y + line.size, line.text, line.size, line.color);
        y += advance(line.size);
    }
}

void place(io::Picture &sheet, int left, int top, const Tile &tile) {
    const io::Picture &picture = tile.picture;
    const std::size_t channels = picture.channels.size();
    const float scale = float(std::exp2(tile.exposure));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            float *to =
                sheet.pixels.data() + 3 * (std::size_t(top + y) * std::size_t(sheet.width) + std::size_t(left + x));
            const std::size_t from = (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * channels;
            for (std::size_t c = 0; c < 3; ++c) to[c] = picture.pixels.empty() ? 0 : picture.pixels[from + c] * scale;
        }
}

} // namespace

io::Picture contact_sheet(const std::string &title, std::size_t columns, const std::vector<Tile> &tiles) {
    columns = std::min(columns, tiles.size());
    const std::size_t rows = (tiles.size() + columns - 1) / columns;
    const std::vector<Line> heading{{title, title_size, bright}};
    std::vector<std::vector<Line>> captions;
    int cell_width = 0, caption_height = 0;
    for (const Tile &tile : tiles) {
        captions.push_back(caption(tile));
        cell_width = std::max({cell_width, tile.picture.width, width_of(captions.back())});
        caption_height = std::max(caption_height, height_of(captions.back()));
    }
    const int head = title.empty() ? 0 : height_of(heading) + tile_gap;
    const int cell_height = tiles.front().picture.height + tile_gap / 2 + caption_height;

    io::Picture sheet;
    sheet.width = 2 * sheet_margin + std::max(width_of(heading), int(columns) * (cell_width + tile_gap) - tile_gap);
    sheet.height = 2 * sheet_margin + head + int(rows) * (cell_height + tile_gap) - tile_gap;
    sheet.channels = {"R", "G", "B"};
    sheet.pixels.assign(std::size_t(sheet.width) * std::size_t(sheet.height) * 3, background);
    sheet.metadata["title"] = title;
    draw_lines(sheet, sheet_margin, sheet_margin, heading);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const int x = sheet_margin + int(i % columns) * (cell_width + tile_gap);
        const int y = sheet_margin + head + int(i / columns) * (cell_height + tile_gap);
        place(sheet, x, y, tiles[i]);
        draw_lines(sheet, x, y + tiles[i].picture.height + tile_gap / 2, captions[i]);
        std::vector<std::string> texts;
        for (const Line &line : captions[i]) texts.push_back(line.text);
        sheet.metadata[fmt::format("panel.{}", i)] = fmt::format("{}", fmt::join(texts, "; "));
    }
    return sheet;
}

} // namespace nacre::sheet
