#include "SampleProject.h"

#include "geometry/Shapes.h"
#include "model/StoredModel.h"

namespace dipwright::test {
namespace {

std::shared_ptr<const TexturedMesh> sampleModel() {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = boxMesh({20, 30, 40});
    for (std::size_t triangle = 0; triangle < model->mesh.triangles.size(); ++triangle) {
        model->textureCoordinates.push_back(
            {Eigen::Vector2f(0, 0), Eigen::Vector2f(1, 0), Eigen::Vector2f(0, 1)});
        model->material.push_back(std::uint16_t(triangle % 2));
    }
    model->materials.resize(2);
    model->materials[0] = {QStringLiteral("shell"), QColor(10, 20, 30), 0};
    model->materials[1] = {QStringLiteral("belly"), QColor(200, 100, 0), -1};
    QImage picture(16, 8, QImage::Format_RGBA8888);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            picture.setPixelColor(x, y, QColor(16 * x, 32 * y, 99, 255 - x));
        }
    }
    model->textures = {picture};
    model->chart = findCharts(*model);
    return model;
}

} // namespace

Project sampleProject() {
    Project project;
    project.name = QStringLiteral("Schildkröte");
    project.date = QStringLiteral("2026-01-31");
    project.model = sampleModel();
    project.modelOrigin = {QStringLiteral("box.obj"),
                           QStringLiteral("box.png"),
                           25.4,
                           QStringLiteral("3 triangles turned"),
                           QStringLiteral("The texture box.png is missing"),
                           "abc",
                           Millimetres(0),
                           {}};
    project.verdict = {0.01,
                       0.03,
                       0.5,
                       0.4,
                       0.06,
                       0.2,
                       0.07,
                       Millimetres(2.5),
                       Advice::DoNotPrint,
                       Advice::CheckFirst,
                       Advice::DoNotPrint,
                       Advice::DoNotPrint};
    project.film.preset = QStringLiteral("custom");
    project.film.width = Millimetres(150);
    project.film.height = Millimetres(200.5);
    project.film.columns = 61;
    project.film.rows = 82;
    project.film.wantedError = Millimetres(0.2);
    project.film.lattice = solver::Lattice::Structural;
    project.film.support = solver::Support::None;
    project.film.edges = {true, false, false, true};
    project.film.swellX = 1.05;
    project.film.swellY = 1.03;
    project.film.relaxationTime = Seconds(0);
    project.film.contactDistance = Millimetres(0.25);
    project.film.growthRate = 0.004;
    project.film.growthLimit = 0.2;
    project.film.gripFade = Degrees(8);
    project.film.gatheringStretch = 0.75;
    project.process.dipSpeed = MillimetresPerSecond(7.5);
    project.process.timeStep = Seconds(0.01);
    project.process.iterations = 9;
    project.process.relaxation = solver::Relaxation::GaussSeidel;
    project.process.selfContact = true;
    project.process.contactTravel = 0.125;
    project.process.depth = Millimetres(12);
    project.process.margin = Millimetres(3);
    project.process.tearStretch = 5;
    project.process.overhang = Degrees(30);
    project.process.solver = QStringLiteral("pbd-cpu");
    project.fieldResolution = 96;
    project.immersions.resize(2);
    project.immersions[0] = {QStringLiteral("Top"),
                             {Degrees(0), Degrees(45), Degrees(0.5)},
                             {Millimetres(1), Millimetres(-2)}};
    project.immersions[1].name = QStringLiteral("Bottom");
    project.inspection.photos = {{QStringLiteral("front.jpg"), QStringLiteral("abc")},
                                 {QStringLiteral("back.jpg"), {}}};
    project.inspection.pairs = {
        {1, {1200.5, 88.25}, {Millimetres(1), Millimetres(-2.5), Millimetres(3)}}};
    project.inspection.chessboard = project.inspection.keepsCamera = true;
    project.filmOnWater = {{{QStringLiteral("tank.jpg"), QStringLiteral("def"), 40.0},
                            {QStringLiteral("later.jpg"), {}, {}}},
                           Seconds(75),
                           QStringLiteral("L7"),
                           28.5,
                           {Millimetres(100.2), Millimetres(99.9)},
                           {Millimetres(99.5), Millimetres(100.1)},
                           Millimetres(0.1),
                           Millimetres(3),
                           Millimetres(28),
                           -0.05,
                           0.01};
    project.sheet = {QStringLiteral("A3"),
                     true,
                     Millimetres(220),
                     Millimetres(330),
                     DotsPerInch(150),
                     Millimetres(4),
                     false,
                     false,
                     false};
    project.ink = {false, 1.5};
    for (const Measure measure : allMeasures()) {
        project.poseAims.weights[measure] = 0.75;
        project.poseAims.limits[measure] = mostLimit(measure) / 2;
    }
    project.poseAims.zoneWeights = {9, 3, 0.5};
    project.asBuilt.corrects = true;
    project.asBuilt.strength = 0.8;
    project.asBuilt.parts = {{QStringLiteral("2026-02-01"), QStringLiteral("Ada"),
                              QStringLiteral("00ff"), 0.4,
                              QStringLiteral("0123456789abcdef 00ff00ff00ff00ff")}};
    project.asBuilt.places = {{1,
                               2,
                               {Millimetres(10), Millimetres(-20.5)},
                               {Millimetres(1), Millimetres(2), Millimetres(3)},
                               {Millimetres(0.25), Millimetres(-0.5)}}};
    return project;
}

bool isSame(const Project& a, const Project& b) {
    return toJson(a) == toJson(b) && writeModel(*a.model) == writeModel(*b.model);
}

} // namespace dipwright::test
