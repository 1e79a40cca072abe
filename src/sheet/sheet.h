#pragma once
#include "io/load.h"
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nacre::sheet {

/// One picture of a sheet: the sheet's scene with these settings, as `--set` would put them in.
struct Panel {
    std::string label;
    std::vector<io::Override> set;
};

/// One scene several times, side by side: what a contact sheet shows.
struct Sheet {
    std::filesystem::path file;
    std::string title;
    std::filesystem::path scene, fallback; // fallback: rendered where files of the scene are missing; may be empty
    std::optional<int> width, height;      // of a panel; the scene's own if not given
    std::optional<std::uint32_t> spp;      // every panel has this many samples per pixel,
    std::optional<double> seconds;         // or samples for this long (kernels alone); the scene's spp if neither
    std::optional<std::uint32_t> columns;  // all panels in one row if not given
    std::vector<Panel> panels;
};

/// Reads a sheet's JSON; paths in it are relative to it. Throws Error{Exit::input}.
Sheet read_sheet(const std::filesystem::path &file);

/// The sheet's scene with the settings of panel `index`. Errors of the settings name the panel; MissingFile where a
/// file of the scene is not there.
scene::Scene load_panel(const Sheet &sheet, std::size_t index);

/// Reads every panel's scene, so that what is wrong shows before anything is rendered. Where a file of the scene is
/// missing and there is a fallback, makes that the sheet's scene and returns what was missing, else "".
std::string check_panels(Sheet &sheet);

} // namespace nacre::sheet
