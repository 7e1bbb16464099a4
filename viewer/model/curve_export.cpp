#include "viewer/model/curve_export.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "viewer/model/convergence_csv.h"

namespace glint {

void CurveExport::save(const ConvergenceWatch& convergence) {
    std::vector<IntegratorCurves> curves;
    curves.reserve(std::size(kIntegratorTable));
    for (const IntegratorInfo& info : kIntegratorTable) {
        curves.push_back({info.kind, *convergence.curve(info.kind), convergence.reference.points(info.kind)});
    }
    guard_->save(path, [this, csv = convergenceCsv(curves)] { start(csv); });
}

void CurveExport::start(const std::string& csv) {
    jobs_->start(
        [this, file = path, free = inputs_->checkIsNoInput(path), csv]() -> JobQueue::Completion {
            const Status result = free ? writeFileAtomically(file, csv) : free;
            return [this, file, result] {
                notice_->tell(result, fmt::format("Saved {}", Notice::placeOf(file)));
                result_.show(notice_->text(), notice_->isError());
            };
        },
        true);
}

}  // namespace glint
