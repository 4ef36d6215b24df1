#include "estimate/limb_chain.h"

#include <algorithm>

namespace limbwave::estimate {

int LimbChain::roots() const {
  return static_cast<int>(
      std::count_if(links.begin(), links.end(), [](const ChainLink& link) { return link.parent < 0; }));
}

LimbChain limb_chain(const body::Rig& rig, const body::Skeleton& skeleton) {
  LimbChain chain;
  std::vector<int> link_of_segment(skeleton.segments.size(), -1);
  for (std::size_t s = 0; s < skeleton.segments.size(); ++s) {
    const body::Segment& segment = skeleton.segments[s];
    for (std::size_t a = 0; a < rig.accelerometers.size(); ++a) {
      if (rig.accelerometers[a].segment != segment.name) {
        continue;
      }
      ChainLink link;
      link.p_LS = rig.accelerometers[a].p_LS;
      link.joint = segment.joint;
      link.p_PL = segment.p_PL;
      link.R_PL_rest = segment.R_PL_rest;
      // Up to the nearest ancestor with a sensor, through segments that rest.
      for (int up = segment.parent; up >= 0; up = skeleton.segments[static_cast<std::size_t>(up)].parent) {
        const auto ancestor = static_cast<std::size_t>(up);
        if (link_of_segment[ancestor] >= 0) {
          link.parent = link_of_segment[ancestor];
          break;
        }
        const body::Segment& between = skeleton.segments[ancestor];
        link.p_PL = between.p_PL + between.R_PL_rest * link.p_PL;
        link.R_PL_rest = between.R_PL_rest * link.R_PL_rest;
      }
      link_of_segment[s] = static_cast<int>(chain.links.size());
      chain.links.push_back(link);
      chain.sensors.push_back(static_cast<int>(a));
    }
  }
  return chain;
}

}  // namespace limbwave::estimate
