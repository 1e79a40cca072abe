#pragma once
#include "device/probe.h"
#include <string>

namespace nacre::test {

/// One combination of everything that a guided walk may be asked.
struct GuidedCase {
    shared::Guiding guiding;
    shared::ChannelSampling sampling;
    Probe probe;
};

std::string name_of(const GuidedCase &c);

/// The first `count` of a fixed sequence, in which pairs of values that were seen least come first: 30 have every value
/// of every factor, 200 every pair that is allowed. dwivedi comes at g = 0 alone; `single` and `albedo` with one
/// extinction and, if guided, one medium for all channels (their weights have no bound otherwise: physics.md, section
/// 5).
std::vector<GuidedCase> guided_cases(int count);

} // namespace nacre::test
