// Tests dipwright-cli from a model to a sheet, through the program itself.
#include "BallModel.h"
#include "CliProcess.h"
#include "TestFiles.h"

#include <QColorSpace>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>
#include <cmath>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

using namespace dipwright::test;

namespace {

// Settings for a coarse and small film, so that a run takes about a second.
const QStringList quickly{"--set", "film.size_mm=120x120",   "--set", "film.points=41x41",
                          "--set", "body.sdf_resolution=64", "--set", "sheet.dpi=100"};

QJsonObject jsonOf(const QString& path) {
    return QJsonDocument::fromJson(bytesOf(path)).object();
}

void compareArray(vtkDataArray* array, int components, vtkIdType tuples, int type) {
    QVERIFY(array);
    QCOMPARE(array->GetNumberOfComponents(), components);
    QCOMPARE(array->GetNumberOfTuples(), tuples);
    QCOMPARE(array->GetDataType(), type);
}

} // namespace

class CliTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        qputenv("DIPWRIGHT_CACHE", path("cache").toLocal8Bit());
        const Outcome made = cli({"new", path("ball.dipw"), "--model", writeBall(folder_.path()),
                                  "--immersion", "name=Top,rotation=0;30;0,offset=2;-3",
                                  "--immersion", "name=Bottom,rotation=180;0;0"});
        QVERIFY2(made.exitCode == 0, made.err);
        const Outcome single = cli({"new", path("single.dipw"), "--model", path("ball.obj")});
        QVERIFY2(single.exitCode == 0, single.err);
        const Outcome done = run({"--out", path("out")});
        QVERIFY2(done.exitCode == 0, done.err);
        summary_ = done;
    }

    void helpAndVersion_everyCommand_arePrinted() {
        const Outcome help = cli({"--help"});
        QCOMPARE(help.exitCode, 0);
        for (const char* command :
             {"new", "run", "pack", "optimize", "info", "validate", "solvers", "bench"}) {
            QVERIFY2(help.out.contains(command), command);
            const Outcome own = cli({command, "--help"});
            QCOMPARE(own.exitCode, 0);
            QVERIFY2(own.out.contains(command) && own.out.contains("--help"), own.out);
            QVERIFY(own.err.isEmpty());
        }
        const QByteArray actions = cli({"artwork", "--help"}).out;
        QVERIFY2(actions.contains("\n       dipwright-cli artwork [options] move JOB.dipw N TO\n"),
                 actions);
        QVERIFY2(actions.contains("\n  ACTION             The action."), actions);
        const Outcome version = cli({"--version"});
        QCOMPARE(version.exitCode, 0);
        QVERIFY(QRegularExpression("^dipwright-cli \\d+\\.\\d+\\.\\d+\n$")
                    .match(version.out)
                    .hasMatch());
    }

    void run_twoDips_writesDocumentedFilesOnly() {
        QStringList expected{"coverage.png",   "proof.png",     "report.json",
                             "ticket.json",    "traveller.pdf", "motion-1.csv",
                             "motion-1.gcode", "motion-2.csv",  "motion-2.gcode"};
        for (const char* immersion : {"immersion-1", "immersion-2"}) {
            for (const char* file : {"sheet.png", "sheet.pdf", "film.vtp", "body.vtp",
                                     "stretch.png", "wrinkling.png", "certainty.png"}) {
                expected.append(QStringLiteral("%1/%2").arg(immersion, file));
            }
        }
        expected.sort();
        QCOMPARE(filesBelow(path("out")), expected);
        QVERIFY(summary_.out.contains("Top") && summary_.out.contains("Bottom"));
    }

    void run_tolerancesOption_reportsZones() {
        const Outcome outcome =
            cli(QStringList{"run", path("ball.dipw"), "--out", path("told"), "--tolerances",
                            "--no-certainty", "--set", "tolerance.samples=0", "--set",
                            "tolerance.turn_deg=0;0;0"} +
                quickly);
        QVERIFY2(outcome.exitCode == 0, outcome.err);
        QVERIFY2(outcome.out.contains("Zone C"), outcome.out);
        const QJsonObject report = jsonOf(path("told/report.json"));
        QCOMPARE(report["zones"].toArray().size(), qsizetype(1));
        QVERIFY(!QImage(path("told/immersion-1/tolerance.png")).isNull());
    }

    void run_languageOption_translatesTheOutput() {
        const Outcome done = cli(QStringList{"run", path("single.dipw"), "--out", path("german"),
                                             "--no-certainty", "--language", "de"} +
                                 quickly);
        QVERIFY2(done.exitCode == 0, done.err);
        for (const char* words :
             {"Quellung geschätzt", "NICHT BEURTEILT", "Punkte", " geschrieben"}) {
            QVERIFY2(done.out.contains(words), words);
        }
        for (const char* words : {"Film: swell", "points", "Coverage", "Wrote"}) {
            QVERIFY2(!done.out.contains(words), done.out);
        }
    }

    void run_severalProjects_continuesAfterFailure() {
        const Outcome all =
            cli(QStringList{"run", path("ball.dipw"), path("missing.dipw"), path("ball.dipw"),
                            "--out", path("queue"), "--no-certainty"} +
                quickly);
        QCOMPARE(all.exitCode, 1);
        QVERIFY2(all.err.contains("missing.dipw") && all.err.contains("2 of 3"), all.err);
        QVERIFY2(all.out.contains("Project 3 of 3"), all.out);
        QCOMPARE(QDir(path("queue")).entryList(QDir::Dirs | QDir::NoDotAndDotDot),
                 (QStringList{"ball", "ball-2"}));
        QCOMPARE(bytesOf(path("queue/ball/immersion-1/sheet.png")),
                 bytesOf(path("queue/ball-2/immersion-1/sheet.png")));
        QCOMPARE(cli({"run", "--out", path("queue")}).exitCode, 2);
    }

    void run_sheet_hasSizeResolutionAndProfile() {
        const QImage sheet(path("out/immersion-1/sheet.png"));
        QCOMPARE(sheet.size(), QSize(472, 472)); // 120 mm at 100 dpi
        QVERIFY(std::abs(sheet.dotsPerMeterX() * 0.0254 - 100) < 0.02);
        QVERIFY(sheet.colorSpace().isValid());
        const QByteArray pdf = bytesOf(path("out/immersion-1/sheet.pdf"));
        QVERIFY(pdf.startsWith("%PDF-") && pdf.trimmed().endsWith("%%EOF"));
    }

    void run_filmVtp_isReadByVtk() {
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(path("out/immersion-1/film.vtp").toLocal8Bit().constData());
        reader->Update();
        vtkPolyData* film = reader->GetOutput();
        QCOMPARE(film->GetNumberOfPoints(), vtkIdType(41 * 41));
        QCOMPARE(film->GetNumberOfPolys(), vtkIdType(2 * 40 * 40));
        vtkPointData* points = film->GetPointData();
        compareArray(points->GetArray("rest"), 3, 41 * 41, VTK_FLOAT);
        compareArray(points->GetArray("adhered"), 1, 41 * 41, VTK_UNSIGNED_CHAR);
        compareArray(points->GetArray("uv"), 2, 41 * 41, VTK_FLOAT);
        compareArray(points->GetArray("stretch"), 1, 41 * 41, VTK_FLOAT);
    }

    void run_bodyVtp_isReadByVtk() {
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(path("out/immersion-2/body.vtp").toLocal8Bit().constData());
        reader->Update();
        vtkPolyData* body = reader->GetOutput();
        QVERIFY(body->GetPointData()->GetTCoords());
        QVERIFY(body->GetCellData()->GetArray("covered"));
        double box[6];
        body->GetBounds(box);
        QVERIFY2(
            std::abs(box[2]) < 1e-3 && std::abs(box[3] - 40) < 0.1,
            qPrintable(QStringLiteral("body.vtp reaches from y = %1 to %2 mm, expected 0 to 40 mm")
                           .arg(box[2])
                           .arg(box[3])));
    }

    void run_pngFiles_canBeRead() {
        QVERIFY(!QImage(path("out/proof.png")).isNull());
        QVERIFY(!QImage(path("out/immersion-2/stretch.png")).isNull());
    }

    void run_reportJson_hasDocumentedFields() {
        const QJsonObject report = jsonOf(path("out/report.json"));
        QCOMPARE(report["version"].toInt(), 1);
        QCOMPARE(report["project"].toString(), QStringLiteral("ball"));
        QVERIFY(QStringList({"print", "look_first", "do_not_print"})
                    .contains(report["verdict"].toString()));
        for (const char* key : {"id", "device", "version"}) {
            QVERIFY(!report["solver"].toObject()[QLatin1String(key)].toString().isEmpty());
        }
        const QJsonArray immersions = report["immersions"].toArray();
        QCOMPARE(immersions.size(), 2);
        for (const QJsonValue& value : immersions) {
            const QJsonObject immersion = value.toObject();
            QVERIFY(hasNumbers(immersion["film"].toObject(),
                               {"columns", "rows", "points", "constraints"}));
            QVERIFY(hasNumbers(
                immersion, {"steps", "wall_seconds", "steps_per_second", "adhered", "coverage"}));
            for (const char* key : {"stretch", "area_stretch"}) {
                const QJsonObject stretch = immersion[QLatin1String(key)].toObject();
                QVERIFY(hasNumbers(stretch, {"min", "mean", "p95", "max"}));
                QVERIFY(stretch["min"].toDouble() <= stretch["mean"].toDouble());
                QVERIFY(stretch["p95"].toDouble() <= stretch["max"].toDouble());
            }
            QVERIFY(hasNumbers(immersion["texture"].toObject(),
                               {"contact", "filled", "seam_triangles"}));
            QVERIFY(hasNumbers(immersion["read_back_mm"].toObject(), {"mean", "p95", "max"}));
            // registration_mm is the earlier name of read_back_mm.
            QCOMPARE(immersion["registration_mm"], immersion["read_back_mm"]);
            const QJsonObject numericalError = immersion["certainty"].toObject();
            QVERIFY(
                hasNumbers(numericalError["off_by_mm"].toObject(), {"min", "mean", "p95", "max"}));
            QVERIFY(!numericalError["reasons"].toArray().isEmpty());
            const QJsonObject marked = immersion["marked"].toObject();
            QVERIFY(hasNumbers(marked,
                               {"area_mm2", "share", "torn_mm2", "unbalanced_mm2", "let_go_mm2"}));
            // marked_area_mm2 is the earlier name of marked.area_mm2.
            QCOMPARE(immersion["marked_area_mm2"], marked["area_mm2"]);
            QVERIFY(hasNumbers(immersion["ink"].toObject(), {"shortfall_area"}));
        }
        const double first = immersions[0].toObject()["coverage"].toDouble();
        const double second = immersions[1].toObject()["coverage"].toDouble();
        const double total = report["coverage_total"].toDouble();
        QVERIFY2(total >= std::max(first, second) - 0.01 && total <= first + second + 0.01,
                 qPrintable(QStringLiteral("coverage is %1 in total, %2 by dip 1, %3 by dip 2")
                                .arg(total)
                                .arg(first)
                                .arg(second)));
        // A ball that is dipped from both sides is painted all round, except in a belt at the
        // waterline.
        QVERIFY2(total > 0.8,
                 qPrintable(QStringLiteral("coverage is %1, expected more than 0.8").arg(total)));
    }

    void run_anyThreadCount_givesSameBytes() {
        const Outcome one = run({"--out", path("one"), "--threads", "1", "--quiet"});
        QCOMPARE(one.exitCode, 0);
        QVERIFY2(one.err.isEmpty(), one.err);
        QCOMPARE(run({"--out", path("two"), "--threads", "2"}).exitCode, 0);
        for (const QString& file : filesBelow(path("out"))) {
            if (file != "report.json") { // contains the times
                QVERIFY2(bytesOf(path("one/" + file)) == bytesOf(path("out/" + file)),
                         qPrintable(file));
                QVERIFY2(bytesOf(path("two/" + file)) == bytesOf(path("out/" + file)),
                         qPrintable(file));
            }
        }
    }

    void run_progress_isPlainLines() {
        QVERIFY(summary_.err.contains(" %  ") && !summary_.err.contains('\r'));
    }

    void run_setOption_changesFilmAndSheet() {
        const Outcome done = cli({"run", path("ball.dipw"), "--out", path("set"), "--dpi", "75",
                                  "--set", "film.points=31x41", "--set", "film.size_mm=90x120",
                                  "--set", "body.sdf_resolution=64"});
        QVERIFY2(done.exitCode == 0, done.err);
        const QJsonObject film = jsonOf(path("set/report.json"))["immersions"]
                                     .toArray()[0]
                                     .toObject()["film"]
                                     .toObject();
        QCOMPARE(film["columns"].toInt(), 31);
        QCOMPARE(film["rows"].toInt(), 41);
        QCOMPARE(QImage(path("set/immersion-1/sheet.png")).size(), QSize(266, 354));
    }

    void run_defaultSheet_isA4At300Dpi() {
        const Outcome done =
            cli({"run", path("single.dipw"), "--out", path("a4"), "--set", "film.points=31x43",
                 "--set", "body.sdf_resolution=64", "--film-image", path("ball.png")});
        QVERIFY2(done.exitCode == 0, done.err);
        const QImage sheet(path("a4/immersion-1/sheet.png"));
        QCOMPARE(sheet.size(), QSize(2480, 3508));
        QCOMPARE(sheet.dotsPerMeterX(), 11811);
        // The picture is stretched over the whole film, so the corners match.
        const QImage picture(path("ball.png"));
        QCOMPARE(sheet.pixel(0, 0), picture.convertToFormat(sheet.format()).pixel(0, 0));
    }

    void run_folderWithEarlierResults_replacesOnlyResults() {
        QFile note(path("two/note.txt"));
        QVERIFY(note.open(QIODevice::WriteOnly));
        note.close();
        const Outcome done = cli(QStringList{"run", path("single.dipw"), "--out", path("two"),
                                             "--film-image", "chessboard"} +
                                 quickly);
        QVERIFY2(done.exitCode == 0, done.err);
        const QStringList files = filesBelow(path("two"));
        QVERIFY(files.contains("note.txt"));
        QVERIFY(files.contains("immersion-1/sheet.png"));
        QVERIFY(files.filter("immersion-2").isEmpty());
        QCOMPARE(files.size(), 14);
        const QImage chess(path("two/immersion-1/sheet.png"));
        const int middle = chess.width() / 2;
        QVERIFY(qGray(chess.pixel(middle + 30, middle + 30)) !=
                qGray(chess.pixel(middle - 30, middle + 30)));
    }

    void info_project_printsContents() {
        const Outcome text = cli({"info", path("ball.dipw"), "--set", "film.swell=1.1;1"});
        QCOMPARE(text.exitCode, 0);
        QVERIFY(text.out.contains("Top") && text.out.contains("1.1"));
        const Outcome graded =
            cli({"info", path("ball.dipw"), "--set", "film.resolution=automatic"});
        QVERIFY2(graded.out.contains("cells as fine as each pose needs"), graded.out);
        const Outcome json = cli({"info", path("ball.dipw"), "--json"});
        const QJsonObject document = QJsonDocument::fromJson(json.out).object();
        QCOMPARE(document["format"].toString(), QStringLiteral("dipwright-project"));
        QCOMPARE(document["immersions"].toArray().size(), 2);
        QCOMPARE(document["model_info"].toObject()["closed"].toBool(), true);
    }

    void setMasks_fromFile_areNamedOrRefused() {
        const auto withMasks = [&](const QByteArray& list) {
            QFile file(path("masks.json"));
            const bool isWritten =
                file.open(QIODevice::WriteOnly) && file.write(list) == list.size();
            return isWritten ? "masks=@" + path("masks.json") : QString();
        };
        const QString all = withMasks(R"([{"extent":"material"}])");
        const Outcome named = cli({"info", path("ball.dipw"), "--set", all});
        QVERIFY2(named.out.contains("Masked areas: 1"), named.out);
        const Outcome json = cli({"info", path("ball.dipw"), "--json", "--set", all});
        const QJsonObject document = QJsonDocument::fromJson(json.out).object();
        QVERIFY(std::abs(document["mask_info"].toObject()["area_mm2"].toDouble() /
                             document["model_info"].toObject()["area_mm2"].toDouble() -
                         1) < 0.001);
        QVERIFY(cli({"validate", path("ball.dipw"), "--set", all}).out.contains("Masked areas: 1"));
        const Outcome warned = cli({"validate", path("ball.dipw"), "--json", "--set", all});
        QVERIFY2(!warned.out.contains("Masked"), warned.out);
        for (const char* wrong : {"", "{", "[5]", R"([{"extent":"spot"}])",
                                  R"([{"radius_mm":1e300}])", R"([{"path":[[0,0,0,0,0,2]]}])"}) {
            const Outcome refused = cli({"info", path("ball.dipw"), "--set", withMasks(wrong)});
            QCOMPARE(refused.exitCode, 2);
        }
        QVERIFY(cli({"info", path("ball.dipw"), "--set", "masks=@" + path("none.json")}).exitCode !=
                0);
    }

    void validate_project_reportsWhetherItCanRun() {
        QCOMPARE(cli({"validate", path("ball.dipw")}).exitCode, 0);
        const Outcome edge =
            cli({"validate", path("ball.dipw"), "--set", "immersions[0].offset_mm=100;0"});
        QCOMPARE(edge.exitCode, 0);
        QVERIFY2(edge.out.contains("warning: Top"), edge.out);
        const Outcome missed =
            cli({"validate", path("ball.dipw"), "--set", "immersions[0].offset_mm=500;0"});
        QCOMPARE(missed.exitCode, 1);
        QCOMPARE(missed.errorLines().size(), 1);
    }

    void validate_sheetOption_reportsNumericalError() {
        const QStringList coarse{"validate",
                                 path("ball.dipw"),
                                 "--sheet",
                                 "--set",
                                 "film.size_mm=80x80",
                                 "--set",
                                 "film.points=16x16",
                                 "--set",
                                 "body.sdf_resolution=64"};
        const Outcome done = cli(coarse + QStringList{"--maps", path("certainty")});
        QVERIFY2(done.exitCode == 0, done.err);
        QVERIFY2(done.out.contains("half the step") && done.out.contains("half the cell"),
                 done.out);
        QVERIFY2(done.out.contains("warning: Top"), done.out);
        QVERIFY(!QImage(path("certainty/certainty-1.png")).isNull());
        const Outcome json = cli(coarse + QStringList{"--json"});
        const QJsonArray immersions =
            QJsonDocument::fromJson(json.out).object()["immersions"].toArray();
        QCOMPARE(immersions.size(), 2);
        QVERIFY(immersions[0].toObject()["half_spacing"].toObject()["p95_mm"].toDouble() > 0);
        QCOMPARE(cli(coarse + QStringList{"--physics"}).exitCode, 2);
    }

    void cli_optionWithoutEffect_isRefused() {
        const QString ball = path("ball.dipw");
        const std::vector<QStringList> wrong{
            {"validate", ball, "--maps", path("maps")},
            {"validate", ball, "--sheet", "--plot", path("plot.png")},
            {"validate", "--physics", "--cells", "20"},
            {"validate", ball, "--sheet", "--maps", ""},
            {"run", ball, "--out", path("empty"), "--film-image", ""},
            {"bench", "--parts", "steps", "--rows", "1", "--plot", ball},
        };
        for (const QStringList& command : wrong) {
            const Outcome refused = cli(command);
            QVERIFY2(refused.exitCode == 2, qPrintable(command.join(' ')));
            QCOMPARE(refused.errorLines().size(), 1);
        }
        QCOMPARE(cli({"info", ball}).exitCode, 0); // not overwritten
        QVERIFY(cli({"run", "--version"}).out.startsWith("dipwright-cli "));
    }

    void new_outputIsTheModel_isRefused() {
        QVERIFY(QFile::copy(path("ball.obj"), path("same.obj")));
        QCOMPARE(cli({"new", path("./same.obj"), "--model", path("same.obj")}).exitCode, 2);
        QCOMPARE(bytesOf(path("same.obj")), bytesOf(path("ball.obj")));
    }

    void validate_bodySmallerThanCells_isRefused() {
        QCOMPARE(cli({"new", path("speck.dipw"), "--model", path("ball.obj"), "--size-mm", "0.1"})
                     .exitCode,
                 0);
        const Outcome refused = cli({"validate", path("speck.dipw")});
        QCOMPARE(refused.exitCode, 1);
        QVERIFY2(refused.err.contains("more points"), refused.err);
    }

    void project_modelFilesRemoved_stillOpens() {
        QTemporaryDir away;
        const QString model = writeBall(away.path());
        QVERIFY(cli({"new", path("own.dipw"), "--model", model}).exitCode == 0);
        QVERIFY(away.remove());
        QCOMPARE(cli({"info", path("own.dipw")}).exitCode, 0);
    }

    void new_sizeOption_scalesLongestEdge() {
        QVERIFY(cli({"new", path("large.dipw"), "--model", path("ball.obj"), "--size-mm", "110"})
                    .exitCode == 0);
        const QJsonObject info =
            QJsonDocument::fromJson(cli({"info", path("large.dipw"), "--json"}).out).object();
        const QJsonArray size = info["model_info"].toObject()["size_mm"].toArray();
        QVERIFY(std::abs(size[1].toDouble() - 110) < 1e-3);
    }

    void new_severalModelsOnJig_makeOneBody() {
        const QString ball = path("ball.obj");
        const QString jig = path("jig.dipw");
        const Outcome made = cli({"new", jig, "--jig", ball + ",name=Left,offset=-25;0", "--jig",
                                  ball + ",name=Right,offset=25;0,height=5", "--quiet"});
        QVERIFY2(made.exitCode == 0, made.err);
        const auto info = [&](const QString& project) {
            return QJsonDocument::fromJson(cli({"info", project, "--json"}).out)
                .object()["model_info"]
                .toObject();
        };
        const QJsonObject both = info(jig), one = info(path("single.dipw"));
        QCOMPARE(both["triangles"].toInt(), 2 * one["triangles"].toInt());
        QVERIFY(both["closed"].toBool());
        QVERIFY(std::abs(both["size_mm"].toArray()[0].toDouble() - 90) < 0.1);
        QVERIFY(std::abs(both["size_mm"].toArray()[1].toDouble() - 45) < 0.1);
        const Outcome ran = cli(QStringList{"run", jig, "--out", path("jig")} + quickly);
        QVERIFY2(ran.exitCode == 0, ran.err);
        // Each ball gets its paint from its own place on the film.
        const QImage sheet(path("jig/immersion-1/sheet.png"));
        const auto printed = [&](double x) { // counts inked pixels within 8 mm of x
            int count = 0;
            const double unit = sheet.width() / 120.0;
            for (int row = -int(8 * unit); row < 8 * unit; ++row) {
                for (int column = -int(8 * unit); column < 8 * unit; ++column) {
                    count += sheet.pixelColor(int((60 + x) * unit) + column,
                                              sheet.height() / 2 + row) != Qt::white;
                }
            }
            return count;
        };
        QVERIFY(printed(-25) > 500 && printed(25) > 500);
        const Outcome met = cli({"new", path("met.dipw"), "--jig", ball, "--jig", ball});
        QCOMPARE(met.exitCode, 1);
        QVERIFY2(met.err.contains("overlap"), met.err);
    }

    void new_presetOption_isStored() {
        QVERIFY(
            cli({"new", path("paper.dipw"), "--model", path("ball.obj"), "--preset", "paper-2020"})
                .exitCode == 0);
        const QJsonObject info =
            QJsonDocument::fromJson(cli({"info", path("paper.dipw"), "--json"}).out).object();
        QCOMPARE(info["film"].toObject()["lattice"].toString(), QStringLiteral("structural"));
        QCOMPARE(info["film"].toObject()["support"].toString(), QStringLiteral("none"));
        const Outcome done =
            cli(QStringList{"run", path("paper.dipw"), "--out", path("paper")} + quickly);
        QVERIFY2(done.exitCode == 0, done.err);
    }

    void optimize_bestPoses_areWrittenToProject() {
        QVERIFY(QFile::copy(path("single.dipw"), path("best.dipw")));
        const Outcome done =
            cli({"optimize", path("best.dipw"), "--immersions", "2", "--candidates", "6",
                 "--directions", "40", "--refined", "1", "--finer", "1", "--confirmed", "1",
                 "--set", "film.size_mm=100x100"});
        QVERIFY2(done.exitCode == 0, done.err);
        QVERIFY2(done.out.contains("coverage"), done.out);
        const QJsonObject info =
            QJsonDocument::fromJson(cli({"info", path("best.dipw"), "--json"}).out).object();
        QCOMPARE(info["immersions"].toArray().size(), 2);
        // Settings that apply only to the search are not saved.
        QCOMPARE(info["film"].toObject()["size_mm"].toArray(), (QJsonArray{210, 297}));

        // A run takes over the dips that the search has cached, but without an estimate of the
        // numerical error it dips again, because cached dips may be refined.
        const QStringList again{"run",       path("best.dipw"), "--set", "film.size_mm=100x100",
                                "--outputs", "sheet_png",       "--out", path("again")};
        const QByteArray cached = cli(again).out;
        QVERIFY2(cached.contains("steps") && !cached.contains("steps in"), cached);
        const QByteArray dipped = cli(again + QStringList{"--no-certainty"}).out;
        QVERIFY2(dipped.contains("NOT JUDGED") && dipped.contains("steps in"), dipped);
    }

    void run_targetThatCannotBeWritten_isRefusedBeforeTheDip() {
        const Outcome run = cli({"run", path("single.dipw"), "--out", path("ball.obj/results"),
                                 "--outputs", "Everything"});
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(run.out.isEmpty() && run.err.contains("is not a folder"), run.out + run.err);
        const Outcome print = cli({"print", path("single.dipw"), "--to", path("missing/a.pdf")});
        QCOMPARE(print.exitCode, 1);
        QVERIFY2(print.out.isEmpty() && print.err.contains("cannot be written"),
                 print.out + print.err);
    }

    void run_failedOutput_namesTheFilesOfAnEarlierRun() {
        const QStringList outputs =
            QStringList{"run",         path("single.dipw"), "--out",
                        path("mixed"), "--outputs",         "sheet_png,report"} +
            quickly;
        QCOMPARE(cli(outputs).exitCode, 0);
        QFile report(path("mixed/report.json"));
        QVERIFY(report.open(QIODevice::Append) && report.write(" ") == 1);
        report.close();
        const Outcome failed = cli(outputs);
        QCOMPARE(failed.exitCode, 1);
        QVERIFY2(failed.err.contains("from an earlier run: report.json ("), failed.err);
    }

    void run_verdictWorseThanRequired_exitCodeIsThree() {
        const QStringList quick{"run",   path("single.dipw"),   "--out", path("required"),
                                "--set", "film.size_mm=100x100"};
        const Outcome unjudged = cli(quick + QStringList{"--no-certainty", "--require", "check"});
        QCOMPARE(unjudged.exitCode, 3);
        QVERIFY2(unjudged.err.contains("results are written"), unjudged.err);
        QVERIFY(QFile::exists(path("required/report.json")));
        const QStringList spoilt{"--set", "verdict.guessed_film=do_not_print"};
        QCOMPARE(cli(quick + spoilt + QStringList{"--no-certainty", "--require", "check"}).exitCode,
                 3);
        QCOMPARE(cli(quick + spoilt + QStringList{"--no-certainty"}).exitCode, 0);
        QCOMPARE(cli(quick + QStringList{"--require", "perhaps"}).exitCode, 2);
        QCOMPARE(cli(quick + QStringList{"--until", "perhaps"}).exitCode, 2);
        QCOMPARE(cli(quick + QStringList{"--work", "-5"}).exitCode, 2);
        QCOMPARE(cli(quick + QStringList{"--until", "print", "--no-certainty"}).exitCode, 2);
        const Outcome fixed =
            cli(quick + QStringList{"--set", "film.points=60x80", "--until", "print"});
        QVERIFY2(fixed.exitCode == 2 && fixed.err.contains("film.resolution=automatic"), fixed.err);
    }

    void optimize_limitsOfProject_areUsed() {
        QVERIFY(QFile::copy(path("single.dipw"), path("wanting.dipw")));
        const QByteArray misses = "misses a limit";
        const QStringList quick{"optimize",     path("wanting.dipw"),
                                "--immersions", "1",
                                "--candidates", "6",
                                "--directions", "6",
                                "--refined",    "0",
                                "--finer",      "1",
                                "--confirmed",  "0"};
        const Outcome set = cli(quick + QStringList{"--set", "pose_search.limits.coverage=1"});
        QVERIFY2(set.exitCode == 0 && set.out.contains(misses), set.out + set.err);
        const Outcome lifted = cli(quick + QStringList{"--set", "pose_search.limits.coverage=1",
                                                       "--limit", "coverage=none"});
        QVERIFY2(lifted.exitCode == 0 && !lifted.out.contains(misses), lifted.out + lifted.err);
        const Outcome wrong = cli(quick + QStringList{"--set", "pose_search.limits.coverage=2"});
        QCOMPARE(wrong.exitCode, 2);
        QVERIFY2(wrong.err.contains("pose_search.limits.coverage"), wrong.err);
    }

    void solvers_installedPlugins_areListed() {
        QVERIFY(cli({"solvers"}).out.contains("pbd-cpu"));
        const QJsonArray solvers = QJsonDocument::fromJson(cli({"solvers", "--json"}).out).array();
        QVERIFY(!solvers.isEmpty());
        for (const QJsonValue& value : solvers) {
            const QJsonObject solver = value.toObject();
            QVERIFY(!solver["id"].toString().isEmpty() && !solver["name"].toString().isEmpty());
            QVERIFY(!solver["version"].toString().isEmpty());
            QVERIFY(!solver["device"].toString().isEmpty());
            QVERIFY(solver["available"].toBool() || !solver["reason"].toString().isEmpty());
        }
    }

#ifdef Q_OS_UNIX
    void run_terminateSignal_leavesNothingBehind() {
        QProcess process;
        process.start(cliPath(), {"run", path("ball.dipw"), "--out", path("cancelled"), "--set",
                                  "film.points=600x848", "--set", "body.sdf_resolution=64"});
        process.setReadChannel(QProcess::StandardError);
        QByteArray output;
        while (!output.contains("Dipping")) {
            QVERIFY(process.waitForReadyRead(-1));
            output += process.readAll();
        }
        process.terminate();
        QVERIFY(process.waitForFinished(-1));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 1);
        const QByteArray rest = process.readAllStandardError();
        QVERIFY2(rest.count("error:") == 1 && rest.contains("ancelled"), rest);
        QVERIFY(!QFileInfo::exists(path("cancelled")));
        QVERIFY(QDir(folder_.path())
                    .entryList({".dipwright-*"}, QDir::AllEntries | QDir::Hidden)
                    .isEmpty());
    }
#endif

private:
    QString path(const QString& name) const {
        return folder_.filePath(name);
    }
    Outcome run(const QStringList& options) const {
        return cli(QStringList{"run", path("ball.dipw")} + quickly + options);
    }

    QTemporaryDir folder_;
    Outcome summary_;
};

QTEST_GUILESS_MAIN(CliTest)
#include "CliTest.moc"
