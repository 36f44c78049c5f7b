// Tests several parts that are dipped together through one film. Each part takes the film below it,
// and neighbours share the film between them.
#include "TestFolders.h"
#include "TexturedBall.h"
#include "dip/JigModel.h"
#include "pipeline/Pipeline.h"
#include "texture/ReverseTexture.h"

#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;

namespace {

constexpr float radius = 15;

JigPart part(const QString& name, const QColor& colour, double x) {
    JigPart part;
    part.model = test::texturedBall(colour);
    part.placed.name = name;
    part.placed.offset[0] = Millimetres(x);
    return part;
}

Project jobOf(const std::vector<JigPart>& parts) {
    Project project;
    project.model = std::make_shared<const TexturedMesh>(jigModel(parts));
    project.film.width = Millimetres(240);
    project.film.height = Millimetres(120);
    project.film.columns = 97;
    project.film.rows = 49;
    project.fieldResolution = 128;
    project.sheet.resolution = DotsPerInch(72);
    project.immersions.resize(1);
    return project;
}

// Returns a project with a red and a blue ball whose centres are `apart` mm apart.
Project twoBalls(double apart) {
    return jobOf({part(QStringLiteral("Red"), QColor(220, 20, 20), -apart / 2),
                  part(QStringLiteral("Blue"), QColor(20, 20, 220), apart / 2)});
}

// Returns the length of film, in mm, between two places of the ball at `x`: its lowest point and
// the place 30° below its equator, on the right or the left.
double filmTo(const ImmersionResult& dip, double x, bool right) {
    const Eigen::Vector3f place(float(x) + (right ? 1 : -1) * radius * std::sqrt(0.75f), radius / 2,
                                0);
    const auto laid = dip.laid->place(dip.body->query.closest(place).point);
    return laid ? std::abs(double(laid->rest.x()) - x) : std::nan("");
}

JobResult run(const Project& project, const SolverRegistry& registry) {
    JobOptions options;
    options.estimatesNumericalError = false;
    return runJob(project, registry, options, nullptr, {});
}

} // namespace

class JigJobTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        registry_ = std::make_unique<SolverRegistry>(QStringList{pluginFolder()});
        far_ = run(twoBalls(110), *registry_);
    }

    void runJob_jig_paintsEachPartFromItsOwnPlace() {
        const QImage sheet = far_.immersions.front().texture->image;
        std::size_t red = 0, blue = 0, astray = 0;
        for (int y = 0; y < sheet.height(); ++y) {
            for (int x = 0; x < sheet.width(); ++x) {
                const QRgb pixel = sheet.pixel(x, y);
                const bool isRed = qAlpha(pixel) > 128 && qRed(pixel) > qBlue(pixel) + 60;
                const bool isBlue = qAlpha(pixel) > 128 && qBlue(pixel) > qRed(pixel) + 60;
                red += isRed;
                blue += isBlue;
                astray += x < sheet.width() / 2 ? isBlue : isRed;
            }
        }
        QVERIFY(red > 3000 && blue > 3000);
        QCOMPARE(astray, std::size_t(0));
    }

    void runJob_jigWithFarParts_equalsSingleDips() {
        Project alone = jobOf({part(QStringLiteral("Red"), QColor(220, 20, 20), 0)});
        alone.immersions[0].offset[0] = Millimetres(-55);
        const JobResult one = run(alone, *registry_);
        for (const bool right : {false, true}) {
            const double together = filmTo(far_.immersions.front(), -55, right);
            // The pose frame of the single ball has its origin at the ball, so the place needs no
            // offset.
            const auto laid = one.immersions.front().laid->place(
                one.immersions.front()
                    .body->query
                    .closest(Eigen::Vector3f((right ? 1 : -1) * radius * std::sqrt(0.75f),
                                             radius / 2, 0))
                    .point);
            QVERIFY(laid);
            const double byItself = std::abs(double(laid->rest.x()) + 55);
            qInfo("%.2f mm together, %.2f alone", together, byItself);
            QVERIFY(std::abs(together - byItself) < 0.5);
        }
    }

    // Both balls pull film from the space between them, so that each ball gets less film on the
    // inside than on the outside.
    void runJob_jigWithNearParts_shareTheFilmBetweenThem() {
        const JobResult near = run(twoBalls(36), *registry_);
        const ImmersionResult& dip = near.immersions.front();
        const double outside = filmTo(dip, -18, false), between = filmTo(dip, -18, true);
        const double otherOutside = filmTo(dip, 18, true), otherBetween = filmTo(dip, 18, false);
        qInfo("outside %.2f and %.2f mm of film, between %.2f and %.2f", outside, otherOutside,
              between, otherBetween);
        QVERIFY(between < outside - 0.3 && otherBetween < otherOutside - 0.3);
        QVERIFY(between + otherBetween < 36); // 36 mm of film lie between the centres
        QVERIFY(std::abs(outside - otherOutside) < 0.2);
        QVERIFY(std::abs(between - otherBetween) < 0.2);
    }

private:
    std::unique_ptr<SolverRegistry> registry_;
    JobResult far_; // two balls far from each other
};

QTEST_MAIN(JigJobTest)
#include "JigJobTest.moc"
