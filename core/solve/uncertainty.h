/// How sure a solve is, as a table for other programs and for the studio.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "solve/solve.h"

namespace limbwave::solve {

/// Rows of time_s, segment, joint_sigma_deg, point_sigma_mm, all segments in the skeleton's order for one time after
/// the other; at most ten times a second, since what is known of a pose changes slowly. Names with commas or quotation
/// marks are quoted (RFC 4180).
std::string uncertainty_to_csv(const Solve::Uncertainty& uncertainty, const body::Skeleton& skeleton);

/// Reads it back. Fails with the line when it has not all segments for every time, or something is not a number.
Result<Solve::Uncertainty> uncertainty_from_csv(std::string_view text, const body::Skeleton& skeleton,
                                                const std::string& place);

/// σ of a segment's joint at a time in degrees, the nearest that there is; 0 without any.
double joint_sigma_deg(const Solve::Uncertainty& uncertainty, std::size_t segment, double time_s);

}  // namespace limbwave::solve
