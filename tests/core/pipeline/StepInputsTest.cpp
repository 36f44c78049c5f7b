// Tests which steps of the job depend on which values of a project. These dependencies decide which
// results are computed again and which are out of date.
#include "pipeline/StepInputs.h"
#include "model/TexturedMesh.h"
#include "pipeline/JobOptions.h"
#include "project/Project.h"

#include <QStringList>
#include <QtTest>

using namespace dipwright;

namespace {

const QString solverId = QStringLiteral("pbd-cpu");

Project plainProject() {
    Project project;
    project.name = QStringLiteral("Box");
    project.model = std::make_shared<const TexturedMesh>();
    project.immersions.resize(2);
    return project;
}

} // namespace

class StepInputsTest : public QObject {
    Q_OBJECT

private slots:
    void stepInputs_changedValue_changesTheStepsThatNeedIt_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("steps"); // the steps of dip 1 that depend on the value
        const auto row = [](const char* path, const char* value, const char* steps) {
            QTest::newRow(path) << QString(path) << QString(value) << QString(steps);
        };
        row("immersions[0].rotation_deg", "0;10;0", "body dip texture sheet");
        row("immersions[0].offset_mm", "3;4", "dip texture sheet");
        row("immersions[0].name", "Bow", "sheet");
        row("immersions[1].rotation_deg", "0;10;0", "texture sheet"); // changes the share of dip 1
        row("immersions[1].name", "Stern", "");
        row("body.sdf_resolution", "256", "field dip texture sheet");
        row("film.swell", "1.1x1.1", "dip texture sheet");
        row("film.points", "40x60", "dip texture sheet");
        row("film.growth_limit", "0.2", "dip texture sheet");
        row("film.gathering_stretch", "0.75", "dip texture sheet");
        row("process.overhang_deg", "30", "dip texture sheet");
        row("process.depth_mm", "12", "dip texture sheet");
        row("process.solver", "pbd-cuda", "");                  // the chosen id is compared instead
        row("artwork.base_colour", "#ff0000", "texture sheet"); // not the dip
        row("ink.limit", "1.5", "texture sheet");
        row("ink.exponents", "1;0.9;0.8", "texture sheet");
        row("ink.black_white_exponents", "0.5;0.7", "texture sheet");
        row("ink.tones", "cyan 0.3 0.5 0.1 2.5", "texture sheet");
        row("share.overlap_mm", "3", "texture sheet");
        row("sheet.bleed_mm", "4", "texture sheet");
        row("sheet.dpi", "200", "texture sheet");
        row("sheet.marks", "false", "sheet");
        row("sheet.cut_line", "ink", "sheet");
        row("sheet.cut_name", "Thru-cut", "sheet");
        row("sheet.cut_bleed_mm", "3", "sheet");
        row("sheet.white", "last", "texture sheet");
        row("sheet.white_choke_mm", "1", "sheet");
        row("body.base_colour", "#102030", "sheet");
    }

    void stepInputs_changedValue_changesTheStepsThatNeedIt() {
        QFETCH(QString, path);
        QFETCH(QString, value);
        const Project before = plainProject();
        Project now = before;
        setByPath(now, path, value);
        QVERIFY(now != before);
        QStringList changed;
        const auto add = [&](const char* step, bool isSame) {
            if (!isSame) {
                changed << QString(step);
            }
        };
        add("body", bodyInputs(before, 0) == bodyInputs(now, 0));
        add("field", fieldInputs(before) == fieldInputs(now));
        add("dip", dipInputs(before, 0, solverId) == dipInputs(now, 0, solverId));
        add("texture",
            textureInputs(before, {}, 0, solverId) == textureInputs(now, {}, 0, solverId));
        add("sheet", sheetInputs(before, {}, 0, solverId) == sheetInputs(now, {}, 0, solverId));
        QTEST(changed.join(' '), "steps");
    }

    void textureInputs_withoutShare_ignoreTheOtherDip() {
        Project before = plainProject();
        before.share.enabled = false;
        Project now = before;
        setByPath(now, QStringLiteral("immersions[1].rotation_deg"), QStringLiteral("0;10;0"));
        QVERIFY(textureInputs(before, {}, 0, solverId) == textureInputs(now, {}, 0, solverId));
        before.share.enabled = now.share.enabled = true;
        before.immersions.resize(1);
        QVERIFY(!textureInputs(before, {}, 0, solverId).share);
    }

    void dipInputs_otherSolver_differ() {
        const Project project = plainProject();
        QVERIFY(dipInputs(project, 0, solverId) !=
                dipInputs(project, 0, QStringLiteral("pbd-cuda")));
    }

    void stepInputs_copiedModel_differ() {
        const Project before = plainProject();
        Project now = before;
        now.model = std::make_shared<const TexturedMesh>(*before.model);
        QVERIFY(bodyInputs(now, 0) != bodyInputs(before, 0));
        QVERIFY(fieldInputs(now) != fieldInputs(before));
    }

    void textureInputs_chessboardOrPicture_differ() {
        const Project project = plainProject();
        const TextureInputs reversed = textureInputs(project, {}, 0, solverId);
        JobOptions options;
        options.chessboard = true;
        const TextureInputs chess = textureInputs(project, options, 0, solverId);
        QVERIFY(chess != reversed);
        QVERIFY(chess.dip == reversed.dip);
        options = {};
        options.filmImage = QImage(2, 2, QImage::Format_RGBA8888);
        options.filmImage.fill(Qt::red);
        const TextureInputs picture = textureInputs(project, options, 0, solverId);
        QVERIFY(picture != reversed && picture != chess);
        QVERIFY(reversed.isReversed() && !chess.isReversed() && !picture.isReversed());
    }
};

QTEST_APPLESS_MAIN(StepInputsTest)
#include "StepInputsTest.moc"
