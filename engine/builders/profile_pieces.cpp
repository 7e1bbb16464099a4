#include "engine/builders/profile_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/builders/bernstein_forms.h"
#include "engine/math/bernstein.h"

namespace glint {
namespace {

/// Pieces of less than this part of a curve have nothing left to tell apart.
constexpr double kLeastWidth = 1e-6;
/// A part is flat where the curve leaves its chord by less than this part of the chord's length,
constexpr double kFlatness = 0.015;
/// or by less than this part of the profile's size.
constexpr double kFlatAnyway = 1e-3;
/// Parts that bend by so many times more will do where they fill whole groups, since one more group costs a
/// ray more than flatter parts save.
constexpr double kMostBend = 4.0;
constexpr int kMostHalvings = 5;
/// Of the profile's size: by how much a piece may leave its curve where that makes its degree lower.
constexpr double kLowerDegreeError = 1e-11;
/// Of the profile's size: more than a ray is off that is known in float.
constexpr double kRingMargin = 1e-5;

using Coefficients = std::array<double, kMaxProfileDegree + 1>;

/// Of the part [begin, end] of a curve, with the bits of its ends that neighbours compute, too.
Coefficients partOf(const double* curve, int degree, double begin, double end) {
    Coefficients part{};
    std::copy(curve, curve + degree + 1, part.begin());
    detail::restrictBernstein(part.data(), degree, begin, end);
    const auto at = [&](double s) {
        return s == 0.0   ? curve[0]
               : s == 1.0 ? curve[degree]
                          : evaluateBernstein<kMaxProfileDegree>(curve, degree, s).value;
    };
    part[0] = at(begin);
    part[static_cast<size_t>(degree)] = at(end);
    return part;
}

/// Where the coordinate turns back.
void addTurns(const double* curve, int degree, std::vector<double>* places) {
    if (degree < 2) { return; }
    Coefficients slope{};
    for (int i = 0; i < degree; ++i) {
        slope[static_cast<size_t>(i)] = curve[i + 1] - curve[i];
    }
    forEachBernsteinRoot<kMaxProfileDegree>(slope.data(), degree - 1,
                                            [&](double s) { places->push_back(s); });
}

/// What one piece is made of.
struct Part {
    uint32_t curve;
    double begin, end;
    int halvings;
    double bend;  ///< above 1: not flat
};

class PieceBuilder {
  public:
    PieceBuilder(const std::vector<ProfileCurve>& curves, const ProfileData& profile,
                 std::vector<ProfilePiece>* pieces, std::vector<PieceGroup>* groups)
        : curves_(curves), profile_(profile), pieces_(pieces), groups_(groups) {
        for (ProfileCurve& curve : curves_) {
            for (int i = 0; i <= curve.degree; ++i) {
                curve.y[i] -= profile_.middle;
            }
        }
    }

    void build() {
        for (uint32_t i = 0; i < curves_.size(); ++i) {
            addMonotoneParts(i);
        }
        halve();
        std::ranges::sort(parts_, {}, [](const Part& part) { return std::pair(part.curve, part.begin); });
        for (const Part& part : parts_) {
            addPiece(part);
        }
    }

  private:
    void addMonotoneParts(uint32_t index) {
        const ProfileCurve& curve = curves_[index];
        std::vector<double> places{0.0, 1.0};
        addTurns(curve.x, curve.degree, &places);
        addTurns(curve.y, curve.degree, &places);
        std::ranges::sort(places);
        double begin = 0.0;
        for (const double end : places) {
            const bool isLast = end == 1.0;
            if (end - begin < kLeastWidth || (!isLast && 1.0 - end < kLeastWidth)) { continue; }
            parts_.push_back(partFrom(index, begin, end, 0));
            begin = end;
        }
    }

    Part partFrom(uint32_t index, double begin, double end, int halvings) const {
        Part part{index, begin, end, halvings, 0.0};
        if (halvings < kMostHalvings) { part.bend = bendOf(part); }
        return part;
    }

    /// The part that bends most, again and again.
    void halve() {
        const auto bendsLess = [](const Part& a, const Part& b) { return a.bend < b.bend; };
        std::ranges::make_heap(parts_, bendsLess);
        while (!parts_.empty()) {
            const Part most = parts_.front();
            const bool fillsGroups = parts_.size() % kGroupPieces == 0;
            if (most.bend <= (fillsGroups ? kMostBend : 1.0)) { break; }
            std::ranges::pop_heap(parts_, bendsLess);
            const double middle = 0.5 * (most.begin + most.end);
            parts_.back() = partFrom(most.curve, most.begin, middle, most.halvings + 1);
            std::ranges::push_heap(parts_, bendsLess);
            parts_.push_back(partFrom(most.curve, middle, most.end, most.halvings + 1));
            std::ranges::push_heap(parts_, bendsLess);
        }
    }

    void addPiece(const Part& part) {
        const ProfileCurve& curve = curves_[part.curve];
        Coefficients x = partOf(curve.x, curve.degree, part.begin, part.end);
        Coefficients y = partOf(curve.y, curve.degree, part.begin, part.end);
        ProfilePiece piece{};
        piece.begin = part.begin;
        piece.width = part.end - part.begin;
        piece.degree = leastDegree(&x, &y, curve.degree);
        piece.curve = part.curve;
        Coefficients one{};
        one.fill(1.0);
        multiplyBernstein(x.data(), x.data(), piece.degree, piece.xSquared);
        multiplyBernstein(y.data(), y.data(), piece.degree, piece.ySquared);
        multiplyBernstein(y.data(), one.data(), piece.degree, piece.yRaised);
        piece.xSquaredFit = fitQuadratic(piece.xSquared, 2 * piece.degree);
        piece.middle = 0.5 * (y[0] + y[static_cast<size_t>(piece.degree)]);
        Coefficients local = y;
        for (double& height : local) {
            height -= piece.middle;
        }
        double localSquared[2 * kMaxProfileDegree + 1];
        multiplyBernstein(local.data(), local.data(), piece.degree, localSquared);
        piece.ySquaredFit = fitQuadratic(localSquared, 2 * piece.degree);
        std::ranges::copy(fitQuadratic(piece.ySquared, 2 * piece.degree).value, piece.ySquaredFit.value);
        piece.yFit = fitQuadratic(piece.yRaised, 2 * piece.degree);
        bernsteinToPowers(x.data(), piece.degree, 0, piece.powers);
        bernsteinToPowers(y.data(), piece.degree, 1, piece.powers);
        addRing(x, y, static_cast<size_t>(piece.degree));
        pieces_->push_back(piece);
    }

    /// Lowers the degree of both coordinates as long as that moves the piece less than rays can tell.
    int leastDegree(Coefficients* x, Coefficients* y, int degree) const {
        double left = kLowerDegreeError * profile_.size();
        for (; degree > 1; --degree) {
            Coefficients lowX = *x, lowY = *y;
            left -= std::max(lowerBernsteinDegree(lowX.data(), degree),
                             lowerBernsteinDegree(lowY.data(), degree));
            if (!(left >= 0.0)) { break; }
            *x = lowX;
            *y = lowY;
        }
        return degree;
    }

    double bendOf(const Part& part) const {
        const ProfileCurve& curve = curves_[part.curve];
        const auto degree = static_cast<size_t>(curve.degree);
        const Coefficients x = partOf(curve.x, curve.degree, part.begin, part.end);
        const Coefficients y = partOf(curve.y, curve.degree, part.begin, part.end);
        const double alongX = x[degree] - x[0], alongY = y[degree] - y[0];
        double most = 0.0;
        for (size_t i = 1; i < degree; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(degree);
            most = std::max(most, std::hypot(x[i] - x[0] - share * alongX, y[i] - y[0] - share * alongY));
        }
        return most / std::max(kFlatness * std::hypot(alongX, alongY), kFlatAnyway * profile_.size());
    }

    void addRing(const Coefficients& x, const Coefficients& y, size_t degree) {
        const auto [lowest, highest] = std::minmax_element(y.begin(), y.begin() + offset(degree + 1));
        const auto [least, most] = std::minmax_element(x.begin(), x.begin() + offset(degree + 1));
        const double margin = kRingMargin * profile_.size();
        const double inner = std::max(0.0, std::max(*least, -*most) - margin);
        const double outer = std::max(*most, -*least) + margin;
        const size_t index = pieces_->size() - profile_.firstPiece;
        const size_t lane = index % kPieceLanes, eight = index / kPieceLanes % kPieceLanes;
        if (lane == 0 && eight == 0) { groups_->push_back(emptyGroup()); }
        PieceGroup& group = groups_->back();
        for (PieceRings* rings : {&group.rings[eight], &group.around}) {
            const size_t i = rings == &group.around ? eight : lane;
            rings->lowest[i] = std::min(rings->lowest[i], static_cast<float>(*lowest - margin));
            rings->highest[i] = std::max(rings->highest[i], static_cast<float>(*highest + margin));
            rings->least2[i] = std::min(rings->least2[i], static_cast<float>(inner * inner));
            rings->most2[i] = std::max(rings->most2[i], static_cast<float>(outer * outer));
        }
    }
    static PieceGroup emptyGroup() {
        PieceRings none;
        std::ranges::fill(none.lowest, kInfinity);
        std::ranges::fill(none.highest, -kInfinity);
        std::ranges::fill(none.least2, kInfinity);
        std::ranges::fill(none.most2, -1.0f);
        PieceGroup group;
        group.around = none;
        std::ranges::fill(group.rings, none);
        return group;
    }
    static std::ptrdiff_t offset(size_t index) { return static_cast<std::ptrdiff_t>(index); }

    std::vector<ProfileCurve> curves_;  ///< heights from the profile's middle
    const ProfileData& profile_;
    std::vector<Part> parts_;
    std::vector<ProfilePiece>* pieces_;
    std::vector<PieceGroup>* groups_;
};

}  // namespace

void addPieces(const std::vector<ProfileCurve>& curves, const ProfileData& profile,
               std::vector<ProfilePiece>* pieces, std::vector<PieceGroup>* groups) {
    PieceBuilder(curves, profile, pieces, groups).build();
}

}  // namespace glint
