// How long it takes to share a body out between two dips, and what comes of it:
//   share_bench [points=CxR] JOB.dipw…
// A line a project: the triangles that are shared out, seconds (the least of five), what is painted
// of what either dip reaches, how much of it by both, the band's width, and the join's length and
// cost against those of the plane halfway between the poses.
#include "dip/Dip.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"

#include <QGuiApplication>
#include <QTextStream>

#include <chrono>

using namespace dipwright;

namespace {

double secondsOf(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void measure(const QString& path, const QString& points, QTextStream& out) {
    Project project = loadProject(path);
    project.share.enabled = true;
    if (!points.isEmpty()) {
        setByPath(project, QStringLiteral("film.points"), points);
    }
    JobOptions options;
    options.estimatesCertainty = false;
    const JobResult result = runJob(project, SolverRegistry(), options, nullptr, {});
    if (!result.share) {
        out << path << ": one dip\n";
        return;
    }
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 5; ++round) {
        least = std::min(least, secondsOf([&] {
                             shareBody(*project.model,
                                       {result.immersions[0].laid, result.immersions[1].laid},
                                       project.share, project.ink, {});
                         }));
    }
    const BodyShare& share = *result.share;
    const ShareAreas& areas = share.areas;
    out << project.name
        << QStringLiteral(": %1 triangles, %2 s, %3 % painted of what is reached, "
                          "%4 % by both, %5 mm; join %6 mm, cost %7; plane %8 mm, "
                          "cost %9\n")
               .arg(share.painters.size())
               .arg(least, 0, 'f', 2)
               .arg(100 * (areas.total() - areas.none) / areas.total() / result.coverageTotal, 0,
                    'f', 1)
               .arg(100 * areas.both / areas.total(), 0, 'f', 1)
               .arg(share.overlap, 0, 'f', 2)
               .arg(share.cost.length, 0, 'f', 0)
               .arg(share.cost.cost, 0, 'f', 1)
               .arg(share.equator.length, 0, 'f', 0)
               .arg(share.equator.cost, 0, 'f', 1);
    out.flush();
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication app(argc, argv);
    QTextStream out(stdout);
    QString points;
    for (const QString& argument : QCoreApplication::arguments().mid(1)) {
        if (argument.startsWith(QLatin1String("points="))) {
            points = argument.mid(7);
        } else {
            measure(argument, points, out);
        }
    }
    return 0;
}
