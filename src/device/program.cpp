#include "device/program.h"
#include "device/cache.h"
#include "device/dump.h"
#include "device/error.h"
#include "device/exact.h"
#include "device/source.h"
#include <chrono>
#include <xxhash.h>

namespace nacre::device {
namespace {

std::string cache_key(const Device &device, const std::string &options, const std::string &source) {
    const std::string all = device.info.platform + '\n' + device.info.name + '\n' + device.info.version + '\n' +
                            device.info.driver + '\n' + options + '\n' + source;
    const XXH128_hash_t hash = XXH3_128bits(all.data(), all.size());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

cl::Program compile(const Device &device, const std::string &source, const std::string &options) {
    cl::Program program(device.context, source);
    try {
        program.build({device.info.device}, options.c_str());
    } catch (const cl::BuildError &error) {
        std::string log;
        for (const auto &[_, text] : error.getBuildLog()) log += text;
        throw Error(Exit::device, device.info.name,
                    fmt::format("{} failed with {} (options {}):\n{}", error.what(), error_name(error.err()), options,
                                located(log, source)));
    }
    return program;
}

std::vector<unsigned char> binary_of(const cl::Program &program) {
    const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
    return binaries.empty() ? std::vector<unsigned char>{} : binaries.front();
}

/// A binary is only a hint: whatever is wrong with it, the source is compiled instead.
bool load(const Device &device, const std::string &key, const std::string &options, cl::Program &program) {
    const auto binary = load_binary(key);
    if (!binary) return false;
    try {
        program = cl::Program(device.context, {device.info.device}, cl::Program::Binaries{*binary});
        program.build({device.info.device}, options.c_str());
        return true;
    } catch (const cl::Error &) {
        return false;
    }
}

} // namespace

std::string options(const Device &device, const Variant &variant) {
    return fmt::format("-cl-std=CL1.2 -DFEATURES={:#x}u{} -DBVH_WIDTH={} -DBVH_VECTOR={} -DBVH_STACK={} -DLANES={} "
                       "-DWORK_GROUP={}{}{}{}{}{}{}{}{}",
                       variant.features, variant.generic ? " -DGENERIC" : "", device.quirks.bvh_width,
                       int(device.quirks.bvh_vector), variant.bvh_stack, variant.lanes, device.quirks.work_group,
                       variant.profile ? " -DPROFILE" : "", variant.tile_list ? " -DTILE_LIST" : "",
                       variant.exact ? " " : "", variant.exact ? exact_options(device) : "",
                       device.quirks.options.empty() ? "" : " ", device.quirks.options,
                       variant.extra.empty() ? "" : " ", variant.extra);
}

Program build(const Device &device, const Variant &variant) {
    const auto start = std::chrono::steady_clock::now();
    const std::string source = assemble(variant.entry, device.kernel_folder), flags = options(device, variant);
    Program result;
    begin_compiling();
    result.hash = cache_key(device, flags, source);
    const bool dump = !device.dump_folder.empty();
    if (dump) dump_source(device.dump_folder, variant.entry, source, flags);
    if (device.quirks.binary_cache && !dump) result.cached = load(device, result.hash, flags, result.program);
    if (!result.cached) {
        result.program = compile(device, source, flags);
        if (device.quirks.binary_cache) {
            const auto binary = binary_of(result.program);
            if (!binary.empty()) store_binary(result.hash, binary);
        }
    }
    result.log = result.program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device.info.device);
    if (dump) dump_result(device.dump_folder, variant.entry, binary_of(result.program), result.log);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

} // namespace nacre::device
