// The table of integrators as objects. Each is defined in its own file, so that one that is forgotten does
// not link.
#include "engine/render/integrator.h"

namespace glint {

const IntegratorType& integratorType(IntegratorKind kind) {
    switch (kind) {
#define GLINT_RETURN_TYPE(kind, key, alias, displayName, help) \
    case IntegratorKind::kind:                                 \
        return typeOf##kind();
        GLINT_INTEGRATORS(GLINT_RETURN_TYPE)
#undef GLINT_RETURN_TYPE
    }
    return typeOfPathTracing();
}

EditKind allOwnEdits() {
    EditKind all = EditKind::None;
    for (const IntegratorInfo& info : kIntegratorTable) {
        all |= integratorType(info.kind).ownEdits();
    }
    return all;
}

std::unique_ptr<ImageStatistics> makeStatistics(IntegratorKind kind, int width, int height) {
    auto statistics = integratorType(kind).makeStatistics();
    if (statistics) { statistics->reset(width, height); }
    return statistics;
}

}  // namespace glint
