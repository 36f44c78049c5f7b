// Tests what is computed for a job whose ink does not suffice.
#include "pipeline/InkOptions.h"
#include "DippedByHand.h"
#include "TestProfiles.h"
#include "geometry/Shapes.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "texture/Ink.h"
#include "texture/ReverseTexture.h"
#include "texture/ToneCurve.h"

#include <QTest>
#include <cmath>

using namespace dipwright;

class InkOptionsTest : public QObject {
    Q_OBJECT

    // The film has grown J = 1.96 sin θ/θ times at the angle θ from the pole of the sphere.
    static JobResult sphere(const QColor& colour) {
        JobResult result;
        const auto model =
            std::make_shared<TexturedMesh>(test::plainModel(sphereMesh(30, 24, 48), colour));
        result.project.model = result.painted = model;
        result.project.ink.limit = 2;
        result.immersions.resize(1);
        ImmersionResult& dip = result.immersions[0];
        dip.laid = test::laid(model->mesh, test::onSphere(test::a4Grid(), 30, 1.5, [](double rest) {
                                  return 1.4 * rest / 30;
                              }));
        dip.sheet.image = QImage(420, 594, QImage::Format_RGBA8888);
        auto texture = std::make_shared<ReverseTexture>();
        texture->shortfallArea = 1900;
        dip.texture = texture;
        return result;
    }

    static const InkOption* option(const InkOptions& found, InkRemedy remedy) {
        const auto it = std::find_if(found.options.begin(), found.options.end(),
                                     [&](const InkOption& one) { return one.remedy == remedy; });
        return it == found.options.end() ? nullptr : &*it;
    }

private slots:
    void toneCurve_densities_keepTheirOrderAndReachTheDensest() {
        QCOMPARE(tonedDensity(0.2f, 1, 2), 0.2f);
        QVERIFY(std::abs(tonedDensity(2, 1, 2) - 1) < 1e-5f);
        QCOMPARE(tonedDensity(3, 1, 2), tonedDensity(2, 1, 2));
        QCOMPARE(tonedDensity(1.5f, 10, 2), 1.5f); // the default changes nothing
        float before = 0;
        for (float density = 0.05f; density <= 2; density += 0.05f) {
            const float toned = tonedDensity(density, 1, 2);
            QVERIFY(toned > before && toned <= density);
            before = toned;
        }
    }

    void ink_secondPass_halvesThePrintedDensityAndShowsTheSame() {
        InkSettings twice;
        twice.passes = 2;
        const LinearColour wanted(0.1f, 0.3f, 0.5f);
        const InkCompensation one({}), two(twice);
        const LinearColour printed = two.print(wanted, 1.4f).colour;
        QVERIFY((printed.square() - one.print(wanted, 1.4f).colour).abs().maxCoeff() < 1e-5f);
        QVERIFY((two.shown(printed, 1.4f) - wanted).abs().maxCoeff() < 1e-4f);
        QVERIFY(one.print(LinearColour::Constant(0.02f), 2).fallsShort);
        QVERIFY(!two.print(LinearColour::Constant(0.02f), 2).fallsShort);
        twice.compensate = false;
        QVERIFY((InkCompensation(twice).print(wanted, 1.4f).colour == wanted).all());
    }

    void options_greySphere_giveWhatTheLawSays() {
        const std::optional<InkOptions> found = inkOptions(sphere(QColor(72, 72, 72)), {});
        QVERIFY(found);
        // The grey has the density 1.188. Ink of the density 2 shows 0.05 less where J > 1.757:
        // within θ = 0.802 of the pole.
        const double area = found->now.shortShare * found->paintedArea;
        QVERIFY2(std::abs(area - 1721) < 40, qPrintable(QString::number(area)));
        QVERIFY(std::abs(found->now.mostMissing - (1.188 - 2 / 1.96)) < 0.01);
        QVERIFY(found->now.missing95 <= found->now.mostMissing && found->now.missing95 > 0.1);
        QVERIFY(std::isnan(found->now.contrast)); // a plain colour

        const InkOption* lighter = option(*found, InkRemedy::LighterTexture);
        QVERIFY(lighter);
        QVERIFY(lighter->reach->shortShare < 0.06 * found->now.shortShare);
        QVERIFY(lighter->reach->colourError > found->now.colourError); // all of the grey is lighter
        // Not lighter than needed: one step denser would leave more than a twentieth.
        QVERIFY(lighter->value > 1.2 && lighter->value < 2);

        const InkOption* second = option(*found, InkRemedy::SecondPass);
        QCOMPARE(second->value, 2.0);
        QCOMPARE(second->reach->shortShare, 0.0);
        QVERIFY(second->reach->colourError < found->now.colourError);

        // White beneath a part without a colour of its own changes nothing.
        const InkOption* white = option(*found, InkRemedy::WhiteBeneath);
        QCOMPARE(white->reach->shortShare, found->now.shortShare);
        QCOMPARE(white->reach->colourError, found->now.colourError);

        const InkOption* pose = option(*found, InkRemedy::OtherPose);
        QVERIFY(!pose->reach);
        QVERIFY2(std::abs(pose->value - 1.757) < 0.02, qPrintable(QString::number(pose->value)));
    }

    void options_colouredPart_whiteBringsTheColourBack() {
        JobResult result = sphere(QColor(72, 72, 72));
        result.project.baseColour = QStringLiteral("#c08040");
        const std::optional<InkOptions> found = inkOptions(result, {});
        const InkOption* white = option(*found, InkRemedy::WhiteBeneath);
        QVERIFY(white->reach->colourError < 0.7 * found->now.colourError);
    }

    void options_eachInkByItself_agreeWithThePlates() {
        JobResult result = sphere(QColor(72, 72, 72));
        Project& project = result.project;
        project.ink.law.exponents = {0.9, 0.8, 0.9, 0.5, 1};
        PrinterProfile& printer = project.profiles.printer.emplace();
        printer.iccProfile = simpleCmykProfile(0.002);
        ReverseTextureOptions options;
        options.pixels = {840, 1188};
        options.bleed = 0;
        options.ink = project.ink;
        options.returnsWanted = true;
        ImmersionResult& dip = result.immersions[0];
        const ReverseTexture texture = reverseTexture(*dip.laid, *result.painted, options, {});
        dip.sheet.image = texture.image;
        dip.sheet.wanted = WantedInk{texture.wanted, texture.stretch, project.ink};
        const PrinterColour colour(printer.iccProfile, printer.intent, printer.blackPoint, "inks");
        dip.inkShortfall = inkShortfall(dip.sheet, {.colour = &colour});
        QVERIFY(*dip.inkShortfall > 100);

        const std::optional<InkOptions> found = inkOptions(result, {});
        QVERIFY(found);
        const double area = found->now.shortShare * found->paintedArea;
        QVERIFY2(std::abs(area - *dip.inkShortfall) < 0.03 * *dip.inkShortfall,
                 qPrintable(QString("%1, plates %2").arg(area).arg(*dip.inkShortfall)));
        QVERIFY(option(*found, InkRemedy::SecondPass)->reach->shortShare <
                0.1 * found->now.shortShare);
        QVERIFY(option(*found, InkRemedy::LighterTexture)->reach->shortShare <
                0.1 * found->now.shortShare);
    }

    void take_option_removesTheShortfall() {
        JobResult result = sphere(QColor(72, 72, 72));
        const std::optional<InkOptions> found = inkOptions(result, {});
        for (const InkOption& one : found->options) {
            JobResult changed = result;
            take(changed.project, one);
            if (one.reach && one.reach->shortShare == 0) {
                QVERIFY(!inkOptions(changed, {}));
            } else if (one.remedy == InkRemedy::OtherPose) {
                QVERIFY(changed.project.poseAims.weights[Measure::Stretch] >
                        result.project.poseAims.weights[Measure::Stretch]);
            } else {
                QVERIFY(std::abs(inkOptions(changed, {})->now.shortShare - one.reach->shortShare) <
                        1e-6);
            }
        }
    }

    void options_inkSuffices_areNone() {
        QVERIFY(!inkOptions(sphere(QColor(200, 200, 200)), {}));
        JobResult amounts = sphere(QColor(72, 72, 72)); // printed without its colours
        auto texture = std::make_shared<ReverseTexture>(*amounts.immersions[0].texture);
        const QImage plane(4, 4, QImage::Format_RGBA8888);
        texture->inks = {plane, plane, QStringLiteral("press")};
        amounts.immersions[0].texture = texture;
        QVERIFY(!inkOptions(amounts, {}));
        JobResult uncompensated = sphere(QColor(72, 72, 72));
        uncompensated.project.ink.compensate = false;
        QVERIFY(!inkOptions(uncompensated, {}));
    }
};

QTEST_APPLESS_MAIN(InkOptionsTest)
#include "InkOptionsTest.moc"
