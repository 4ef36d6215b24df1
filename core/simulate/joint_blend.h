/// From one motion of a joint to another without leaving what the joint can do.
#pragma once

#include "body/skeleton.h"
#include "simulate/jets.h"

namespace limbwave::simulate {

/// From a to b (R_PL with rest) with the weight s (0..1): ball joints along the shorter way, hinges and universal
/// joints by their angles, which a straight way between two rotations of a universal joint would not keep to. Both are
/// what the joint can do.
QuaternionJet blend(const body::Segment& segment, const QuaternionJet& a, const QuaternionJet& b, const Jet& s);

}  // namespace limbwave::simulate
