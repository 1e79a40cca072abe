#include "scene/check.h"
#include "scene/check_colors.h"
#include "scene/normalise.h"
#include "scene/topology.h"
#include <algorithm>
#include <fmt/format.h>

namespace nacre::scene {

namespace {

// The ends of the domain that tests/stress shows to hold. Mean free paths, of the scene's size: at 3e-6 the colour of a
// body far from the scene's centre is .2 % too bright, at 1e-6 .7 %, at 1e-7 7 %. Length over width of a triangle: at
// 1e2 one walk in 2,000 slips through a body of such triangles, at 1e4 one in 15.
constexpr double least_free_path = 3e-6;
constexpr double longest_sliver = 1000;

const Value &of(const Material &material, shared::Parameter parameter) { return material[parameter]; }

bool scatters(const Material &material) {
    const Value &weight = of(material, shared::PARAMETER_subsurface_weight);
    return weight.texture >= 0 || weight.value.maxCoeff() > 0;
}

bool emits(const Material &material) {
    return of(material, shared::PARAMETER_emission_luminance).value.maxCoeff() > 0 ||
           of(material, shared::PARAMETER_emission_luminance).texture >= 0;
}

// Weights of walks whose channel is drawn without regard to how far it got grow without end where mean free paths
// differ (memo 17-07, section 3.1): a mean of 4096 samples of scenes/features/channel_albedo.json was still 2.5 % too
// dark.
bool has_endless_weights(const Scene &scene, const Material &material) {
    const shared::ChannelSampling sampling = scene.render.channel_sampling;
    if (sampling != shared::CHANNEL_SINGLE && sampling != shared::CHANNEL_ALBEDO) return false;
    const Value &scale = of(material, shared::PARAMETER_subsurface_radius_scale);
    return scale.texture >= 0 || scale.value.minCoeff() < scale.value.maxCoeff();
}

// One object, with what is found in it.
class ObjectCheck {
  public:
    ObjectCheck(const Object &object, const Material &material, double scene_size)
        : object(object), material(material), scene_size(scene_size) {}

    std::vector<Finding> run() {
        edges();
        shells();
        triangles();
        if (scatters(material)) scattering_length();
        if (scatters(material)) slivers();
        if (scatters(material) && material.model != shared::MODEL_RANDOM_WALK) diffusion();
        uvs();
        return std::move(findings);
    }

  private:
    void find(std::string text) { findings.push_back({object.name, std::move(text)}); }

    void edges() {
        if (topology.open_edges)
            find(fmt::format("{} open edges: the mesh has holes{}", topology.open_edges,
                             scatters(material) ? ""
                                                  ", light inside gets lost through them and colours come out darker "
                                                  "than asked for; close them"
                                                : ""));
        if (topology.non_manifold_edges)
            find(fmt::format("{} edges have more than two triangles: what is inside is not clear there",
                             topology.non_manifold_edges));
        if (topology.inconsistent_edges)
            find(fmt::format("{} edges lie between triangles of opposite winding: turn one side round",
                             topology.inconsistent_edges));
    }

    // A shell turned inwards inside another is a cavity, and right.
    bool is_cavity(const Shell &shell) const {
        return std::any_of(topology.shells.begin(), topology.shells.end(), [&](const Shell &other) {
            return other.closed && other.volume > 0 && other.box.contains(shell.box);
        });
    }

    void shells() {
        std::size_t turned = 0, count = 0;
        for (const Shell &shell : topology.shells)
            if (shell.closed && shell.volume < 0 && !is_cavity(shell)) {
                ++turned;
                count += shell.triangles;
            }
        if (turned)
            find(fmt::format("inside out: {} of {} shells ({} triangles) face inwards; reverse their triangles", turned,
                             topology.shells.size(), count));
    }

    void triangles() {
        if (object.degenerate) find(fmt::format("{} triangles without area were dropped", object.degenerate));
        if (const std::size_t opposed = count_opposed_normals(object.mesh))
            find(fmt::format("{} of {} triangles have a vertex normal on their other side; \"smooth\": false ignores "
                             "the normals of the file",
                             opposed, object.mesh.triangles.size()));
    }

    void scattering_length() {
        const Value &radius = of(material, shared::PARAMETER_subsurface_radius);
        const Value &scale = of(material, shared::PARAMETER_subsurface_radius_scale);
        if (radius.texture >= 0 || scale.texture >= 0) return; // known only where it is read
        const Bounds box = bounds(object.mesh);
        const double size = box.diagonal().norm(), thinnest = box.sizes().minCoeff();
        const double longest = radius.value.x() * scale.value.maxCoeff();
        const double shortest = radius.value.x() * scale.value.minCoeff();
        const double proposal = 0.02 * (thinnest > 0 ? thinnest : size);
        const auto propose = [&](double length, const char *looks) {
            find(fmt::format("material '{}': the mean free path {:.3g} is {:.2g} times the object's size {:.3g}, {}; "
                             "did you mean subsurface_radius = {:.2g}?",
                             material.name, length, length / size, size, looks, proposal));
        };
        if (longest > 0.5 * size)
            propose(longest, "so it looks transparent");
        else if (shortest < 1e-5 * size)
            propose(shortest, "so it is very slow and looks like paint");
        if (shortest < least_free_path * scene_size)
            find(fmt::format(
                "material '{}': the mean free path {:.3g} is less than {} of the scene's size {:.3g}, positions "
                "are rounded to more than walks can do with, and colours come out too bright; render what is "
                "far away apart, or use a longer subsurface_radius",
                material.name, shortest, least_free_path, scene_size));
    }

    // Where a ray meets a triangle is rounded by 1e-7 of its length times its length over its width.
    void slivers() {
        std::size_t count = 0;
        for (const auto &triangle : object.mesh.triangles) {
            const Vec3 &a = object.mesh.positions[triangle[0]], &b = object.mesh.positions[triangle[1]],
                       &c = object.mesh.positions[triangle[2]];
            const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
            count += (b - a).cross(c - a).norm() * longest_sliver < longest;
        }
        if (count)
            find(fmt::format(
                "{} of {} triangles are more than {} times as long as wide: walks may slip out through them, "
                "with their light; divide them along their length",
                count, object.mesh.triangles.size(), longest_sliver));
    }

    void diffusion() {
        const Value &bleed = of(material, shared::PARAMETER_subsurface_bleed);
        if (bleed.texture >= 0 || bleed.value.x() > 0)
            find(fmt::format("material '{}': subsurface_bleed is of the random walk alone, its subsurface_model knows "
                             "no flights",
                             material.name));
        if (material.entry != shared::ENTRY_LAMBERT)
            find(fmt::format("material '{}': subsurface_entry is of the random walk alone, its subsurface_model "
                             "enters as lambert does",
                             material.name));
        if (material.max_depth > 0)
            find(fmt::format("material '{}': subsurface_max_depth is of the random walk alone", material.name));
    }

    void uvs() {
        if (!object.mesh.uvs.empty()) return;
        const bool textured = std::any_of(material.values.begin(), material.values.end(),
                                          [](const Value &value) { return value.texture >= 0; });
        if (textured) find(fmt::format("material '{}' has textures, the mesh has no uvs", material.name));
    }

    const Object &object;
    const Material &material;
    const double scene_size;
    const Topology topology = find_topology(object.mesh);
    std::vector<Finding> findings;
};

} // namespace

std::vector<Finding> check(const Scene &scene) {
    std::vector<Finding> findings;
    bool any_emits = false;
    const double size = frame_of(scene).size;
    for (const Object &object : scene.objects) {
        const Material &material = scene.materials[object.material];
        if (scatters(material))
            for (const std::string &text : check_colors(scene, material))
                findings.push_back({object.name, fmt::format("material '{}': {}", material.name, text)});
        if (scatters(material) && has_endless_weights(scene, material))
            findings.push_back(
                {object.name, fmt::format("material '{}': render.channel_sampling suits channels with the "
                                          "same mean free path; here few samples of great weight are "
                                          "missing, and it looks too dark; take hero",
                                          material.name)});
        any_emits = any_emits || emits(material);
        std::vector<Finding> found = ObjectCheck(object, material, size).run();
        std::move(found.begin(), found.end(), std::back_inserter(findings));
    }
    const bool lit = std::any_of(scene.lights.begin(), scene.lights.end(),
                                 [](const Light &light) { return light.radiance.maxCoeff() > 0; });
    if (!lit && !any_emits) findings.push_back({scene.file, "has no light, the picture will be black"});
    for (const std::string &warning : scene.warnings) findings.push_back({scene.file, "not used: " + warning});
    return findings;
}

} // namespace nacre::scene
