#include "render/upload.h"
#include "base/error.h"
#include "device/buffer.h"
#include "render/camera.h"
#include "render/clearance.h"
#include "render/control.h"
#include "render/convert.h"
#include "render/guides.h"
#include "render/inversion.h"
#include "render/light_sides.h"
#include "render/returned.h"
#include "shared/returned.h"
#include <algorithm>
#include <optional>
#include <xxhash.h>

namespace nacre::render {
namespace {

using namespace shared;

/// Makes buffers and keeps their names and sizes for the statistics.
class Uploader {
  public:
    Uploader(const device::Device &device, DeviceScene &out)
        : device(device), limit(device.info.device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()), name(device.info.name),
          out(out) {}

    template <typename T> void add(const std::string &what, const std::vector<T> &data) {
        add_bytes(what, data.data(), data.size() * sizeof(T));
    }

    void add_bytes(const std::string &what, const void *data, std::size_t bytes) {
        DeviceScene::Entry entry{what, {}, bytes};
        if (bytes > limit)
            throw Error(Exit::device, name,
                        fmt::format("the scene's {} take {} MB, this device allows {} MB in one buffer", what,
                                    bytes >> 20, limit >> 20));
        hash = XXH3_64bits_withSeed(data, bytes, hash);
        entry.buffer = device::constant_buffer(device, data, bytes);
        out.buffers.push_back(std::move(entry));
    }

    std::uint64_t hash = 0;

  private:
    const device::Device &device;
    std::uint64_t limit;
    std::string name;
    DeviceScene &out;
};

Material to_device(const scene::Material &source, const scene::Frame &frame) {
    Material material{};
    for (int p = 0; p < PARAMETER_COUNT; ++p) {
        material.value[p] = to_float4(source.values[p].value);
        material.texture[p] = source.values[p].texture;
    }
    material.value[PARAMETER_subsurface_radius] = to_float4(source[PARAMETER_subsurface_radius].value / frame.size);
    material.radius_scale = float(1 / frame.size);
    material.flight = source.flight;
    material.entry = source.entry;
    material.max_depth = source.max_depth;
    material.internal_reflection = source.internal_reflection ? 1 : 0;
    material.model = source.model;
    return material;
}

/// Texels of all images one after the other, and how materials read them.
void pack_textures(const scene::Scene &scene, std::vector<Texture> &textures, std::vector<std::uint16_t> &texels) {
    std::vector<std::uint32_t> first;
    for (const scene::Image &image : scene.images) {
        first.push_back(std::uint32_t(texels.size()));
        texels.insert(texels.end(), image.halves.begin(), image.halves.end());
    }
    texels.resize(texels.size() + 3); // the last one is read as four: kernels/texture/texture.h
    for (const scene::Texture &source : scene.textures) {
        const scene::Image &image = scene.images[source.image];
        Texture texture{};
        texture.first = first[source.image];
        texture.width = image.width;
        texture.height = image.height;
        texture.channels = image.channels;
        texture.channel = image.channels == 1 ? -1 : source.channel;
        texture.scale_u = float(source.scale.x());
        texture.scale_v = float(source.scale.y());
        texture.offset_u = float(source.offset.x());
        texture.offset_v = float(source.offset.y());
        textures.push_back(texture);
    }
}

} // namespace

cl_uint DeviceScene::bind(cl::Kernel &kernel) const {
    cl_uint index = 0;
    for (const Entry &entry : buffers) kernel.setArg(index++, entry.buffer);
    return index;
}

const DeviceScene::Entry &DeviceScene::entry(std::string_view name) const {
    return *std::find_if(buffers.begin(), buffers.end(), [&](const Entry &entry) { return entry.name == name; });
}

DeviceScene upload(const device::Device &device, const scene::Scene &scene, std::uint32_t features, const Crop &crop,
                   Timeline *timeline) {
    DeviceScene out;
    const scene::Frame units = scene::frame_of(scene);
    const auto timed = [&](const char *name, double &seconds, auto &&work) {
        const Span span(timeline, name, &seconds);
        return work();
    };
    Geometry geometry = timed("build BVH", out.startup.bvh,
                              [&] { return build_geometry(scene, units, features, device.quirks.bvh_width); });
    out.startup.bvh_parts = geometry.bvh.times;
    if (scene.render.clearance)
        timed("build clearance", out.startup.clearance, [&] {
            add_clearance(scene, units, std::uint64_t(scene.render.spp) * crop.width() * crop.height(), geometry);
        });
    const LightSet lights = timed("lights", out.startup.lights, [&] { return build_lights(scene, units); });
    std::optional<Span> uploading(std::in_place, timeline, "upload", &out.startup.upload);
    for (std::size_t i = 0; i < geometry.objects.size(); ++i) geometry.objects[i].first_light = lights.first_light[i];
    out.unit = lights.unit;
    out.length = units.size;
    // Few sizes of stack, so that scenes share programs.
    out.bvh_stack = (std::max(64u, geometry.bvh.stack) + 31) / 32 * 32;

    Frame &frame = out.frame;
    frame.camera = to_device(scene.camera, scene.image, units);
    frame.width = std::uint32_t(scene.image.width);
    frame.height = std::uint32_t(scene.image.height);
    frame.crop_x = crop.x0;
    frame.crop_y = crop.y0;
    frame.crop_width = crop.width();
    frame.crop_height = crop.height();
    frame.seed = scene.render.seed;
    const bool controlled = choose_control(scene, units, features, geometry);
    if (controlled) features |= FEATURE_CONTROL;
    if (std::any_of(geometry.objects.begin(), geometry.objects.end(),
                    [](const Object &object) { return object.plate; }))
        features |= FEATURE_SLABS;
    frame.lone_rays = controlled ? 1 : 0;               // until measure sees that nothing in sight has one
    const bool guided = choose_guided(scene, geometry); // by what choose_control has found
    if (!guided) features &= ~std::uint32_t(FEATURE_GUIDE_EIGEN | FEATURE_GUIDE_DWIVEDI);
    frame.features = features | (geometry.clearance.empty() ? 0u : std::uint32_t(FEATURE_CLEARANCE));
    frame.light_count = std::uint32_t(lights.table.size());
    frame.environment_count = lights.environment_count;
    frame.rect_first = lights.environment_count;
    frame.rect_count = lights.rect_count;
    frame.bvh_root = geometry.root;
    frame.max_depth = scene.render.max_depth;
    frame.channel_sampling = scene.render.channel_sampling;
    frame.object_count = std::uint32_t(scene.objects.size());
    frame.scene_radius = 0.5f;
    frame.emission_scale = float(1 / lights.unit);

    std::vector<Material> materials;
    for (const scene::Material &material : scene.materials) materials.push_back(to_device(material, units));
    std::vector<GuideMode> modes;
    if (guided) add_guides(scene, !(features & FEATURE_ANISOTROPY), materials, modes);
    std::vector<float> similarities;
    add_albedos(scene, materials, similarities);
    std::vector<float> returned;
    if (controlled) add_returned(scene, geometry, !(features & FEATURE_ANISOTROPY), materials, returned);
    std::vector<Texture> textures;
    std::vector<std::uint16_t> texels;
    if (features & FEATURE_TEXTURES) pack_textures(scene, textures, texels);

    Uploader uploader(device, out); // in the order of SCENE_PARAMETERS
    uploader.add_bytes("frame", &frame, sizeof frame);
    uploader.add("nodes", geometry.bvh.nodes);
    uploader.add("blocks", geometry.bvh.blocks);
    uploader.add("objects", geometry.objects);
    uploader.add("triangles", geometry.triangles);
    uploader.add("normals", geometry.normals);
    uploader.add("uvs", geometry.uvs);
    uploader.add("materials", materials);
    uploader.add("textures", textures);
    uploader.add("texels", texels);
    uploader.add("lights", lights.lights);
    uploader.add("light_table", lights.table);
    uploader.add("environment_table", lights.environment_table);
    uploader.add("environment", lights.environment);
    uploader.add("clearance", geometry.clearance);
    uploader.add("guide", modes);
    uploader.add("similarities", similarities);
    uploader.add("returned", returned);
    const bool measured = guided || controlled;
    uploader.add("light_sides", std::vector<LightSides>(measured ? scene.objects.size() : 0, all_alike));
    uploader.add("thickness", std::vector<float>(measured ? geometry.world.size() : 0, GUIDE_THICK));
    if (measured) out.light_points = light_points(scene, geometry);
    for (std::size_t i = 0; i < geometry.objects.size(); ++i)
        if (is_measured(geometry.objects[i]))
            out.measured.push_back({uint(i), geometry.walk_blocks[i], geometry.objects[i].first_primitive,
                                    geometry.objects[i].plate != 0, geometry.objects[i].control_thickness});
    uploader.add("slabs", std::vector<Slab>()); // measure finds out whether there are some
    uploader.add("transmitted", std::vector<float>());
    out.materials = std::move(materials);
    out.hash = fmt::format("{:016x}", uploader.hash);
    uploading.reset();
    return out;
}

} // namespace nacre::render
