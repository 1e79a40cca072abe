#include "app/commands.h"
#include "device/context.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace nacre::app {
namespace {

const char *type_name(cl_device_type type) {
    return type & CL_DEVICE_TYPE_GPU ? "gpu" : type & CL_DEVICE_TYPE_CPU ? "cpu" : "accelerator";
}

int list(bool as_json) {
    const auto devices = device::list_devices();
    if (as_json) {
        nlohmann::ordered_json document = nlohmann::ordered_json::array();
        for (const auto &info : devices)
            document.push_back({{"index", info.index},
                                {"name", info.name},
                                {"platform", info.platform},
                                {"type", type_name(info.type)},
                                {"version", info.version},
                                {"driver", info.driver},
                                {"memory", info.memory},
                                {"compute_units", info.compute_units}});
        fmt::print("{}\n", document.dump(2));
    } else {
        for (const auto &info : devices)
            fmt::print("{}  {}  {}  ({}, {}, {} units, {:.1f} GiB)\n", info.index, type_name(info.type), info.name,
                       info.platform, info.version, info.compute_units, double(info.memory) / (1 << 30));
    }
    if (devices.empty()) device::open_device(); // throws the error that says what to install
    return 0;
}

} // namespace

Run add_devices(CLI::App &program) {
    CLI::App *command = program.add_subcommand("devices", "List the OpenCL devices.");
    const auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "Print JSON.");
    return [as_json] { return list(*as_json); };
}

} // namespace nacre::app
