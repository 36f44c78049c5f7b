// Measures how long it takes to split a body between two dips, and prints the result:
//   share_bench [points=CxR] JOB.dipw…
// Prints two lines per project. The first line: number of triangles; seconds (least of five runs);
// painted share of the surface that either dip reaches; share that both dips paint; width of the
// overlap; length and cost of the seam, relative to the plane halfway between the poses. The second
// line is for a second film that is shifted by 0.7 mm in four directions: the share of the overlap
// whose reflectance changes by more than 0.1 (meaningful for plain bodies only), and the largest
// change.
#include "Bench.h"
#include "dip/Dip.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"
#include "results/Results.h"
#include "texture/LinearLight.h"

#include <QGuiApplication>
#include <QTextStream>

using namespace dipwright;

namespace {

struct Slipped {
    double share = 0;   // share of the overlap whose reflectance changes by more than 0.1
    double largest = 0; // largest change of reflectance
};

Slipped slipped(const JobResult& result) {
    const RefinedMesh& mesh = *result.share->fade.mesh;
    std::vector<FilmAppearance> films;
    for (const ImmersionResult& immersion : result.immersions) {
        films.push_back({immersion.laid, immersion.texture->image});
    }
    const InkSettings& ink = result.project.ink;
    const std::vector<QRgb> right = printedColours(mesh, films, ink);
    std::vector<double> changes(right.size());
    for (const auto& [x, z] : {std::pair(0.7, 0.0), {-0.7, 0.0}, {0.0, 0.7}, {0.0, -0.7}}) {
        films.back().slip.shift = {Millimetres(x), Millimetres(z)};
        const std::vector<QRgb> off = printedColours(mesh, films, ink);
        for (std::size_t triangle = 0; triangle < off.size(); ++triangle) {
            changes[triangle] = std::max(changes[triangle],
                                         std::abs(linearFromSrgb(qGreen(off[triangle]) / 255.0) -
                                                  linearFromSrgb(qGreen(right[triangle]) / 255.0)));
        }
    }
    Slipped worst;
    double overlap = 0;
    for (std::size_t triangle = 0; triangle < changes.size(); ++triangle) {
        if (result.share->painters[triangle] == Painter::Both) {
            const double area = triangleArea(mesh.mesh(), triangle);
            overlap += area;
            worst.share += changes[triangle] > 0.1 ? area : 0;
            worst.largest = std::max(worst.largest, changes[triangle]);
        }
    }
    worst.share /= std::max(overlap, 1e-9);
    return worst;
}

void measure(const QString& path, const QString& points, QTextStream& out) {
    Project project = loadProject(path);
    project.share.enabled = true;
    if (!points.isEmpty()) {
        setByPath(project, QStringLiteral("film.points"), points);
    }
    JobOptions options;
    options.estimatesNumericalError = false;
    const JobResult result = runJob(project, SolverRegistry(), options, nullptr, {});
    if (!result.share) {
        out << path << ": one dip\n";
        return;
    }
    const bench::Statistics seconds = bench::timed(5, [&] {
        shareBody(*shareStage(*project.model, fineBody(project.model->mesh)),
                  {result.immersions[0].laid, result.immersions[1].laid}, project.share,
                  project.ink, {});
    });
    const BodyShare& share = *result.share;
    const ShareAreas& areas = share.areas;
    out << project.name
        << QStringLiteral(": %1 triangles, %2 s, %3 % painted of what is reached, "
                          "%4 % by both, %5 mm, %6 % too narrow; join %7 mm, cost %8, against the "
                          "plane's %9 % length and %10 % cost\n")
               .arg(share.painters.size())
               .arg(seconds.minimum, 0, 'f', 2)
               .arg(100 * (areas.total() - areas.none) / areas.total() / result.coverageTotal, 0,
                    'f', 1)
               .arg(100 * areas.both / areas.total(), 0, 'f', 1)
               .arg(QStringLiteral("%1 to %2")
                        .arg(share.overlap.least, 0, 'f', 1)
                        .arg(share.overlap.most, 0, 'f', 1))
               .arg(100 * share.narrow, 0, 'f', 1)
               .arg(share.cost.length, 0, 'f', 0)
               .arg(share.cost.cost, 0, 'f', 1)
               .arg(100 * (share.cost.length / share.equator.length - 1), 0, 'f', 0)
               .arg(100 * (share.cost.cost / share.equator.cost - 1), 0, 'f', 0);
    const Slipped off = slipped(result);
    out << QStringLiteral("    0.7 mm off: %1 % of the overlap by more than 0.1, at most %2\n")
               .arg(100 * off.share, 0, 'f', 1)
               .arg(off.largest, 0, 'f', 2);
    out.flush();
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication app(argc, argv);
    QTextStream out(stdout);
    const bench::Arguments arguments(argc, argv);
    for (const std::string& path : arguments.words()) {
        measure(QString::fromStdString(path), QString::fromStdString(arguments.value("points")),
                out);
    }
    return 0;
}
