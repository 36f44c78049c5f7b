#include "accuracy/certainty/Verdict.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Certainty)
};

using Kind = VerdictReason::Kind;

double area(const FilmContact& contact, const FilmTriangle& corners) {
    const Eigen::Vector3f a = contact.places[corners[0]];
    const Eigen::Vector3f b = contact.places[corners[1]];
    const Eigen::Vector3f c = contact.places[corners[2]];
    return double((b - a).cross(c - a).norm()) / 2;
}

// Which film points hang together, joined two at a time.
class Parts {
public:
    explicit Parts(std::size_t points) : parent_(points) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t(0));
    }
    std::uint32_t of(std::uint32_t point) const {
        while (parent_[point] != point) {
            point = parent_[point];
        }
        return point;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t one = of(a), other = of(b);
        parent_[std::max(one, other)] = std::min(one, other);
        parent_[a] = parent_[b] = std::min(one, other); // short ways from here on
    }

private:
    std::vector<std::uint32_t> parent_;
};

// The painted film by how far its corners may be off.
class OffByAreas {
public:
    // `pointsOffBy` empty: nothing is known of it.
    OffByAreas(const LaidFilm& own, std::vector<float> pointsOffBy)
        : own_(own), offBy_(std::move(pointsOffBy)), parts_(own.film().positions.size()) {
        for (std::size_t triangle = 0; triangle < own.triangles().size(); ++triangle) {
            if (own.contact().painted[triangle]) {
                add(std::uint32_t(triangle));
            }
        }
    }

    double painted = 0, uncertain = 0, far = 0; // mm² of the body

    std::vector<UncertainPlace> places() const {
        std::map<std::uint32_t, UncertainPlace> byPart; // in the points' order
        for (const auto& [corners, area] : uncertainTriangles_) {
            UncertainPlace& place = byPart[parts_.of(corners[0])];
            const bool isFirst = place.area == 0;
            place.area += area;
            for (const std::uint32_t point : corners) {
                if ((isFirst && point == corners[0]) || offBy(point) > place.offBy) {
                    place.offBy = offBy(point);
                    place.rest = restPosition(own_.film().grid, point);
                    place.place = onModel(point);
                }
            }
        }
        std::vector<UncertainPlace> places;
        for (const auto& [part, place] : byPart) {
            places.push_back(place);
        }
        std::stable_sort(places.begin(), places.end(),
                         [](const auto& a, const auto& b) { return a.area > b.area; });
        places.resize(std::min(places.size(), mostPlaces));
        return places;
    }

private:
    void add(std::uint32_t triangle) {
        const FilmTriangle& corners = own_.triangles()[triangle];
        const double here = area(own_.contact(), corners);
        double worst = 0;
        for (const std::uint32_t point : corners) {
            worst = std::max(worst, offBy(point));
        }
        painted += here;
        far += worst > farOff ? here : 0;
        if (worst > certainOffBy || has(own_.marks(triangle), solver::PointMark::Unbalanced)) {
            uncertain += here;
            uncertainTriangles_.emplace_back(corners, here);
            parts_.join(corners[0], corners[1]);
            parts_.join(corners[0], corners[2]);
        }
    }

    // What is not known counts for nothing: the border is told of by itself.
    double offBy(std::uint32_t point) const {
        return offBy_.empty() || std::isnan(offBy_[point]) ? 0 : double(offBy_[point]);
    }

    Eigen::Vector3f onModel(std::uint32_t point) const {
        return own_.body().modelToPose.inverse().cast<float>() * own_.contact().places[point];
    }

    const LaidFilm& own_;
    std::vector<float> offBy_;
    Parts parts_;
    std::vector<std::pair<FilmTriangle, double>> uncertainTriangles_;
};

// What speaks against a sheet, and what it comes to.
struct Objections {
    Advice advice = Advice::Print;
    std::vector<VerdictReason> reasons;

    void add(Advice worst, const VerdictReason& reason) {
        reasons.push_back(reason);
        advice = std::max(advice, worst);
    }
};

VerdictReason tooFarOff(const solver::FilmGrid& grid, const CertaintyEstimate& estimate) {
    const double offBy = estimate.offBy.percentile95;
    // Of the cells, if the error goes on falling as they do.
    const double finer = std::min(certainHalfSpacing / estimate.halfSpacing().distance.percentile95,
                                  certainOffBy / offBy);
    if (finer < finestCellNamed) {
        return {Kind::OffByMuch, offBy};
    }
    const bool isGraded = !grid.columnPlaces.empty();
    return {Kind::OffBy, offBy, {}, isGraded ? grid.leastSpacing() * std::min(finer, 1.0) : 0};
}

void objectToEstimate(Objections& found, const CertaintyEstimate& estimate, double farShare,
                      const solver::FilmGrid& grid) {
    const SheetChange spacing = estimate.halfSpacing();
    const SheetChange step = estimate.halfStep();
    const double offBy = estimate.offBy.percentile95;
    const double once = std::max(spacing.paintedOnce, step.paintedOnce);
    if (spacing.painted == 0 || step.painted == 0) {
        found.add(Advice::DoNotPrint, {Kind::NothingPaints});
        return;
    }
    if (offBy > farOff || spacing.distance.percentile95 > certainHalfSpacing) {
        found.add(offBy > farOff ? Advice::DoNotPrint : Advice::LookFirst,
                  tooFarOff(grid, estimate));
    }
    if (once > certainPaintedOnce) {
        found.add(once > spoiltPaintedOnce ? Advice::DoNotPrint : Advice::LookFirst,
                  {Kind::Border, once});
    }
    if (step.distance.percentile95 > certainHalfStep) {
        found.add(Advice::LookFirst, {Kind::Step, step.distance.percentile95});
    }
    if (offBy <= farOff && farShare > mostFarOffArea) {
        found.add(Advice::LookFirst, {Kind::FarOffPlaces, farShare});
    }
}

// `estimate` null: none was asked for.
Objections objections(const DippedFilm& film, const CertaintyEstimate* estimate, double farShare) {
    Objections found;
    if (estimate && estimate->failure.isEmpty()) {
        objectToEstimate(found, *estimate, farShare, film.grid);
    } else if (estimate) {
        found.add(Advice::LookFirst, {Kind::NotCompared, 0, estimate->failure});
    }
    if (film.equilibrium.stepsWithout > 0) {
        found.add(Advice::LookFirst, {Kind::Unbalanced,
                                      double(film.equilibrium.stepsWithout),
                                      {},
                                      film.equilibrium.worstForceLeft});
    }
    return found;
}

QString percent(double share) {
    return QLocale().toString(100 * share, 'f', share < 0.1 ? 1 : 0);
}

} // namespace

Verdict verdict(const LaidFilm& own, const CertaintyEstimate* estimate) {
    const OffByAreas areas(own, estimate ? estimate->pointsOffBy : std::vector<float>());
    const double farShare = areas.painted > 0 ? areas.far / areas.painted : 0;
    Objections found = objections(own.film(), estimate, farShare);
    std::vector<VerdictReason>& reasons = found.reasons;
    if (!estimate) {
        found.advice = Advice::NotJudged;
        reasons.insert(reasons.begin(), {Kind::NotAsked});
    } else if (reasons.empty()) {
        reasons.push_back({Kind::Certain, estimate->offBy.percentile95});
    }
    return {found.advice, std::move(reasons), areas.places(), areas.uncertain};
}

QString adviceText(Advice advice) {
    switch (advice) {
    case Advice::NotJudged:
        return Text::tr("Not judged");
    case Advice::Print:
        return Text::tr("Print it");
    case Advice::LookFirst:
        return Text::tr("Look at these places first");
    case Advice::DoNotPrint:
        return Text::tr("Do not print");
    }
    return {};
}

QString millimetres(double length) {
    return Text::tr("%1 mm").arg(QLocale().toString(length, 'f', 2));
}

QString reasonText(const VerdictReason& reason, const LengthText& length) {
    switch (reason.kind) {
    case Kind::NotAsked:
        return Text::tr("The dip was not compared with coarser ones.");
    case Kind::NotCompared:
        return Text::tr("The dip could not be compared with coarser ones: %1.").arg(reason.text);
    case Kind::NothingPaints:
        return Text::tr("Nothing is painted alike by this dip and by coarser ones.");
    case Kind::Certain:
        return Text::tr("95 % of the sheet is off by %1 or less for numerical reasons.")
            .arg(length(reason.value));
    case Kind::OffBy:
        if (reason.most > 0) {
            return Text::tr("The sheet may be off by up to %1 for numerical reasons (95 % of it); "
                            "try a cell size of %2 for the film, turn the body, or dip it in two "
                            "immersions.")
                .arg(length(reason.value), length(reason.most));
        }
        return Text::tr("The sheet may be off by up to %1 for numerical reasons (95 % of it); give "
                        "the film more points, turn the body, or dip it in two immersions.")
            .arg(length(reason.value));
    case Kind::OffByMuch:
        return Text::tr("The sheet may be off by up to %1 for numerical reasons (95 % of it), too "
                        "far to tell which cells would do; give the film smaller cells or more "
                        "points, turn the body, or dip it in two immersions.")
            .arg(length(reason.value));
    case Kind::FarOffPlaces:
        return Text::tr("%1 % of the painted area may be off by more than %2.")
            .arg(percent(reason.value), length(farOff));
    case Kind::Step:
        return Text::tr("The sheet may move by up to %1 with other steps (95 % of it); choose a "
                        "smaller contact travel.")
            .arg(length(reason.value));
    case Kind::Border:
        return Text::tr("The paint's border is not certain: %1 % of the body is painted by finer "
                        "or coarser dips only.")
            .arg(percent(reason.value));
    case Kind::Unbalanced:
        return Text::tr("%1 steps of the dip ended without equilibrium, with up to %2 % of the "
                        "elastic forces left.")
            .arg(QLocale().toString(qlonglong(reason.value)), percent(reason.most));
    }
    return {};
}

QString verdictText(const QString& immersion, const Verdict& verdict) {
    QStringList sentences;
    for (const VerdictReason& reason : verdict.reasons) {
        sentences.append(reasonText(reason, millimetres));
    }
    return Text::tr("%1: %2. %3")
        .arg(immersion, adviceText(verdict.advice), sentences.join(QLatin1Char(' ')));
}

QString adviceKey(Advice advice) {
    switch (advice) {
    case Advice::NotJudged:
        return QStringLiteral("not_judged");
    case Advice::Print:
        return QStringLiteral("print");
    case Advice::LookFirst:
        return QStringLiteral("look_first");
    case Advice::DoNotPrint:
        return QStringLiteral("do_not_print");
    }
    return {};
}

} // namespace dipwright
