#pragma once
#include "albedo/memo.h"
#include "patch/survey.h"

namespace nacre::patch {

/// How far colours come out from what was asked, by the solver of half-spaces, over g in [0, .95] and colours in
/// [.002, .999]. Albedos above 1 are taken as 1.
struct FitError {
    double largest, mean;
};
FitError fit_error(const albedo::MemoFit &fit);

/// The memo's way: eq 6 for each g, then eqs 7 and 8 through its parameters. Both in colour: the second stage weighs
/// parameters by what they do to the colours of their g, and so keeps what one makes up for in another.
albedo::MemoFit fit_in_two_stages(const Survey &survey, const albedo::MemoFit &start);

/// All coefficients of eq 9 at once, least squares of colour.
albedo::MemoFit fit_jointly(const Survey &survey, const albedo::MemoFit &start);

} // namespace nacre::patch
