// Measures how well coarse dips rank poses:
//   pose_ranking_bench [solver=ID] [poses=N] [exact] JOB.dipw…
// Dips the body of each job in N directions, which are chosen as in a search, with the job's own
// film and with coarser films. Prints one line per film:
// - milliseconds per dip
// - difference of the objective from the objective with the job's own film: mean and standard
//   deviation
// - rank correlation with the job's own film (Spearman)
// - how many of the five best poses of the job's own film are among the coarse film's first twelve
// - loss of objective if the best of the coarse film's first 1, 3, 6 or 12 poses is chosen
// - mean difference of each measure
// With `exact`, prints one line per pose instead, with commas: number; objective with cells of 1/20
// and 1/40 of the body's length and with the job's film; cell of the second and of the job's film,
// mm; predicted verdict and doublings of the work; verdict on the job's first dip, its numerical
// error in mm, and its reasons.
#include "Bench.h"
#include "pipeline/JobSearch.h"
#include "project/Project.h"
#include "project/ProjectStore.h"
#include "search/Objective.h"
#include "search/PoseCandidates.h"
#include "search/PoseDips.h"
#include "solver/SolverRegistry.h"

#include <QGuiApplication>
#include <QTextStream>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace dipwright;

namespace {

struct Dips {
    std::vector<std::shared_ptr<const JudgedPose>> poses;
    std::vector<PoseMeasures> measures; // one entry per pose
    std::vector<double> objectives;
    double seconds = 0;
};

std::vector<std::size_t> order(const std::vector<double>& values) {
    std::vector<std::size_t> result(values.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    std::stable_sort(result.begin(), result.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
    return result;
}

double rankCorrelation(const std::vector<double>& one, const std::vector<double>& other) {
    std::vector<double> ranks(one.size());
    const std::vector<std::size_t> first = order(one), second = order(other);
    for (std::size_t rank = 0; rank < first.size(); ++rank) {
        ranks[first[rank]] += double(rank);
        ranks[second[rank]] -= double(rank);
    }
    const double n = double(one.size());
    const double squares = std::inner_product(ranks.begin(), ranks.end(), ranks.begin(), 0.0);
    return 1 - 6 * squares / (n * (n * n - 1));
}

// Returns the numerical error that a verdict states for zone C, mm; 0 if it states none.
double offByOf(const Verdict& verdict) {
    for (const VerdictReason& reason : verdict.reasons) {
        switch (reason.kind) {
        case VerdictReason::Kind::Certain:
        case VerdictReason::Kind::OffBy:
        case VerdictReason::Kind::OffByMuch:
        case VerdictReason::Kind::Step:
            return reason.value;
        default:
            break;
        }
    }
    return 0;
}

class Ranking {
public:
    Ranking(const Project& project, const SolverRegistry& registry, const QString& solver,
            int poses)
        : subject_(searchSubject(project, solver)), module_(registry.module(solver)),
          body_(subject_, settings_.aims.zoneWeights, SurfaceColours(*subject_.model)) {
        settings_.simulated = poses;
        const CoveragePreview preview(subject_.model->mesh);
        const PoseCandidates candidates =
            poseCandidates(preview, std::vector<float>(preview.areas().size(), 1), subject_.film,
                           subject_.process, settings_, {});
        for (const std::size_t chosen : candidates.chosen) {
            immersions_.push_back(candidates.all[chosen].immersion);
        }
    }

    void tellAll(QTextStream& out) {
        own_ = dipped(jobDetail);
        tell(jobDetail, out);
        const double residual = jobDetail.residual;
        for (const DipDetail& detail :
             {DipDetail{15, 128, 0.5, residual}, DipDetail{20, 128, 0.5, residual},
              DipDetail{20, 128, 0.35, residual}, DipDetail{30, 128, 0.5, residual},
              DipDetail{40, 128, 0.5, residual}, DipDetail{40, 128, 0.35, residual},
              DipDetail{60, 128, 0, residual}}) {
            tell(detail, out);
        }
    }

    void tellExactness(QTextStream& out) {
        const Dips coarse = dipped(coarseDetail), finer = dipped(finerDetail);
        subject_.film.work = 0; // the verdict on the first cells
        own_ = dipped(jobDetail);
        for (std::size_t pose = 0; pose < immersions_.size(); ++pose) {
            const JudgedPose &ranked = *finer.poses[pose], &own = *own_.poses[pose];
            const PredictedSheet sheet = body_.predicted(*coarse.poses[pose], ranked);
            out << QStringLiteral("  pose,%1,%2,%3,%4,%5,%6,%7,%8,%9,%10")
                       .arg(pose)
                       .arg(coarse.objectives[pose], 0, 'f', 4)
                       .arg(finer.objectives[pose], 0, 'f', 4)
                       .arg(own_.objectives[pose], 0, 'f', 4)
                       .arg(ranked.cell, 0, 'f', 4)
                       .arg(own.cell, 0, 'f', 4)
                       .arg(adviceKey(sheet.advice))
                       .arg(sheet.doublings, 0, 'f', 2)
                       .arg(adviceKey(own.verdict.advice))
                       .arg(offByOf(own.verdict), 0, 'f', 4);
            for (const VerdictReason& reason : own.verdict.reasons) {
                out << "," << reasonKey(reason.kind) << "=" << reason.value;
            }
            out << "\n";
        }
        out.flush();
    }

    std::size_t poses() const { return immersions_.size(); }

private:
    void tell(const DipDetail& detail, QTextStream& out) const {
        const Dips dips = std::isinf(detail.cells) ? own_ : dipped(detail);
        const std::size_t count = immersions_.size();
        std::vector<double> more(count);
        for (std::size_t pose = 0; pose < count; ++pose) {
            more[pose] = dips.objectives[pose] - own_.objectives[pose];
        }
        const double mean = std::accumulate(more.begin(), more.end(), 0.0) / double(count);
        double variance = 0;
        for (const double each : more) {
            variance += (each - mean) * (each - mean) / double(count);
        }
        const std::vector<std::size_t> coarse = order(dips.objectives),
                                       own = order(own_.objectives);
        int found = 0;
        for (std::size_t rank = 0; rank < std::min<std::size_t>(5, count); ++rank) {
            const auto end = coarse.begin() + std::ptrdiff_t(std::min<std::size_t>(12, count));
            found += std::find(coarse.begin(), end, own[rank]) != end;
        }
        const auto lost = [&](std::size_t among) {
            double best = 0;
            for (std::size_t rank = 0; rank < std::min(among, count); ++rank) {
                best = std::max(best, own_.objectives[coarse[rank]]);
            }
            return own_.objectives[own[0]] - best;
        };
        const QString name = std::isinf(detail.cells)
                                 ? QStringLiteral("own film")
                                 : QStringLiteral("%1 cells, field %2, travel %3")
                                       .arg(detail.cells)
                                       .arg(detail.field)
                                       .arg(detail.travel);
        out << QStringLiteral("  %1: %2 ms; objective %3 ± %4; rank %5; %6 of 5; lost %7 %8 %9 %10 "
                              "of %11\n   ")
                   .arg(name)
                   .arg(1000 * dips.seconds / double(count), 0, 'f', 1)
                   .arg(mean, 0, 'f', 4)
                   .arg(std::sqrt(variance), 0, 'f', 4)
                   .arg(rankCorrelation(dips.objectives, own_.objectives), 0, 'f', 3)
                   .arg(found)
                   .arg(lost(1), 0, 'f', 4)
                   .arg(lost(3), 0, 'f', 4)
                   .arg(lost(6), 0, 'f', 4)
                   .arg(lost(12), 0, 'f', 4)
                   .arg(own_.objectives[own[0]], 0, 'f', 4);
        for (const Measure measure : allMeasures()) {
            double difference = 0;
            for (std::size_t pose = 0; pose < count; ++pose) {
                difference += dips.measures[pose][measure] - own_.measures[pose][measure];
            }
            out << QStringLiteral(" %1 %2")
                       .arg(measureKey(measure))
                       .arg(difference / double(count), 0, 'f', 4);
        }
        out << "\n";
        out.flush();
    }

    Dips dipped(const DipDetail& detail) const {
        const PoseDips poses(
            subject_, body_, module_, detail,
            cachedDistanceField(subject_.model->mesh, fieldResolution(subject_, detail), {}), {});
        Dips dips;
        std::vector<std::shared_ptr<const JudgedPose>>& all = dips.poses;
        all.resize(immersions_.size());
        dips.seconds = bench::secondsOf([&] {
            poses.dip(immersions_, all, [](std::size_t) {});
            for (const auto& judged : all) {
                dips.measures.push_back(body_.measures({judged.get()}));
                dips.objectives.push_back(
                    objective(dips.measures.back(), settings_, body_.equator()));
            }
        });
        return dips;
    }

    SearchSettings settings_;
    SearchSubject subject_;
    const solver::SolverModule& module_;
    JudgedBody body_;
    std::vector<Immersion> immersions_;
    Dips own_;
};

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication app(argc, argv);
    QTextStream out(stdout);
    bench::Arguments arguments(argc, argv);
    const bool isExact = arguments.take("exact");
    const QString solver = QString::fromStdString(arguments.value("solver", "auto"));
    const SolverRegistry registry;
    for (const std::string& path : arguments.words()) {
        const Project project = loadProject(QString::fromStdString(path));
        Ranking ranking(project, registry, solver, arguments.number("poses", 96));
        out << project.name << ", " << ranking.poses() << " poses\n";
        if (isExact) {
            ranking.tellExactness(out);
        } else {
            ranking.tellAll(out);
        }
    }
    return 0;
}
