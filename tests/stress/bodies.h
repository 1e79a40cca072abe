#pragma once
#include "render/session.h"
#include "scene/scene.h"
#include <string>
#include <vector>

namespace nacre::stress {

/// A cube of edge 1 and what it is made of; lengths in edges.
struct Body {
    double g = 0, bleed = 0;
    Vec3 albedo{1, 1, 1};
    double free_path = 0.1;
    Vec3 scale{1, 1, 1}; // of the free path, by channel
    shared::FlightLaw flight = shared::FLIGHT_RENEWAL;
    shared::Entry entry = shared::ENTRY_LAMBERT;
    std::uint32_t max_depth = 0;
};

/// How bodies are looked at.
struct Look {
    int pixels = 2; // of each side of a body
    std::uint32_t spp = 16, seed = 1;
    shared::Guiding guiding = shared::GUIDING_NONE;
    shared::ChannelSampling sampling = shared::CHANNEL_HERO;
    double scale = 1; // of all there is, the free paths and the camera too
    Vec3 offset{0, 0, 0};
};

/// What a body, or a picture, looks like: the mean over its pixels and samples, its standard error, the largest
/// pixel.
struct Seen {
    Vec3 mean{0, 0, 0}, error{0, 0, 0};
    double largest = 0;
    bool finite = true;

    /// No NaN, no infinity, nothing negative, and no more light than fell in (1), by 4 standard errors and `slack`.
    bool sound(double slack) const;
    /// `mean` within 4 standard errors and `slack` of `exact`.
    bool is(const Vec3 &exact, double slack) const;
    std::string text() const;
};

struct Shown {
    std::vector<Seen> bodies;
    render::Statistics statistics;
};

/// Renders bodies side by side in a white sky, fronts in one plane, each seen alone by an orthographic camera: hundreds
/// in one picture and one program. Their fronts do not see each other.
Shown show(const std::vector<Body> &bodies, const Look &look);

/// Asks for the layer `variance`.
render::Options with_variance();

/// The mean of a picture with the layer `variance` over the pixels [x0, x1) x [y0, y1).
Seen seen(const io::Picture &picture, int x0, int y0, int x1, int y1);

scene::Material material_of(const Body &body);

} // namespace nacre::stress
