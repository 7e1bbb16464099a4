// A list of boxes with what is in them, or of items without a box, and its walk: structures that exist to
// show what better ones gain.
#pragma once

#include "engine/kernels/box_test.h"
#include "engine/kernels/geometry_view.h"

namespace glint {

/// Items [first, first + count) of what leaves hold.
struct LeafItems {
    uint32_t first, count;
};

struct BoxedItems {
    Bounds bounds;
    LeafItems items;
};

/// From box to box; without boxes, whatever they are.
class ListWalk {
  public:
    GLINT_HD explicit ListWalk(const AcceleratorView& list)
        : next_(list.as<BoxedItems>()),
          end_(next_ + list.bytes / sizeof(BoxedItems)),
          hasBoxes_(list.kind == AcceleratorKind::Aabb) {}

    /// The items of the next box that the ray meets before tMax; false: there is none.
    template <class Tests>
    GLINT_HD bool next(const BoxRay& ray, float tMin, float tMax, Tests tests, LeafItems* items) {
        while (next_ != end_) {
            const BoxedItems& entry = *next_++;
            float tEnter, tLeave;
            if (hasBoxes_) {
                tests.countBoxes(1);
                if (!boxHit(entry.bounds, ray, tMin, tMax, &tEnter, &tLeave)) { continue; }
            }
            *items = entry.items;
            return true;
        }
        return false;
    }

  private:
    const BoxedItems* next_;
    const BoxedItems* end_;
    bool hasBoxes_;
};

}  // namespace glint
