// Gives dipwright-cli bad input. The program must print one sentence, return the right exit code
// and leave no unfinished file.
#include "BallModel.h"
#include "CliProcess.h"
#include "TestFiles.h"

#include <QImage>
#include <QtTest>
#include <array>
#ifndef _WIN32
#include <sys/stat.h>
#endif

using namespace dipwright::test;

namespace {

// Returns a PNG whose header claims this size, but which contains no pixels.
QByteArray pngClaiming(quint32 width, quint32 height) {
    QByteArray header("IHDR");
    for (const quint32 number : {width, height}) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            header.append(char(number >> shift));
        }
    }
    header.append(QByteArray("\x08\x02\x00\x00\x00", 5));
    quint32 crc = 0xffffffffu;
    for (const char byte : header) {
        crc ^= quint8(byte);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1u) != 0 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
        }
    }
    crc ^= 0xffffffffu;
    QByteArray png("\x89PNG\r\n\x1a\n\0\0\0\x0d", 12);
    png += header;
    for (int shift = 24; shift >= 0; shift -= 8) {
        png.append(char(crc >> shift));
    }
    return png;
}

QSet<QString> everythingIn(const QString& folder) {
    const QDir::Filters all = QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot;
    const QStringList names = QDir(folder).entryList(all);
    return {names.begin(), names.end()};
}

} // namespace

class BadInputTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        QVERIFY(cache_.isValid());
        qputenv("DIPWRIGHT_CACHE", cache_.path().toLocal8Bit());
        writeBall(folder_.path());
        QVERIFY(cli({"new", path("ball.dipw"), "--model", path("ball.obj")}).exitCode == 0);
        writeFile(path("empty.obj"), {});
        writeFile(path("picture.obj"), bytesOf(path("ball.png")));
        writeFile(path("text.stl"), "once upon a time");
        writeFile(path("cut.stl"),
                  QByteArray(80, ' ') + QByteArray("\xff\x00\x00\x00", 4) + QByteArray(70, 0));
        writeFile(path("points.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
        writeFile(path("nan.obj"), "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
        writeFile(path("flat.obj"), "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n");
        writeFile(path("empty.png"), {});
        writeFile(path("text.png"), "this is no picture");
        writeFile(path("none.png"), pngClaiming(0, 0));
        writeFile(path("vast.png"), pngClaiming(100'000, 100'000));
        QVERIFY(QDir(folder_.path()).mkpath("deep"));
        writeFile(path("deep/outside.obj"),
                  bytesOf(path("ball.obj")).replace("mtllib ", "mtllib ../"));
        const QByteArray project = bytesOf(path("ball.dipw"));
        writeFile(path("empty.dipw"), {});
        writeFile(path("cut.dipw"), project.left(project.size() / 2));
        writeFile(path("text.dipw"), "once upon a time");
        writeFile(path("file"), "a file, not a folder");
    }

    void cli_wrongUsage_exitCodeIsTwo_data() {
        QTest::addColumn<QStringList>("arguments");
        const QString job = path("ball.dipw");
        QTest::newRow("no command") << QStringList{};
        QTest::newRow("unknown command") << QStringList{"fly"};
        QTest::newRow("no number of dips") << QStringList{"optimize", job};
        QTest::newRow("three dips") << QStringList{"optimize", job, "--immersions", "3"};
        QTest::newRow("too few candidates")
            << QStringList{"optimize", job, "--immersions", "1", "--candidates", "1"};
        QTest::newRow("unknown option") << QStringList{"run", job, "--fly"};
        QTest::newRow("no project") << QStringList{"run", "--out", path("out")};
        // Unlike `info`, `run` accepts several projects.
        QTest::newRow("two projects") << QStringList{"info", job, job};
        QTest::newRow("two projects, no out") << QStringList{"run", job, job};
        QTest::newRow("pack without --out") << QStringList{"pack", job};
        QTest::newRow("pack 0 copies") << QStringList{"pack", job + ":0", "--out", path("out")};
        QTest::newRow("pack on a film without a height")
            << QStringList{"pack", job, "--out", path("out"), "--film", "210"};
        QTest::newRow("pack on a film of size 0")
            << QStringList{"pack", job, "--out", path("out"), "--film", "roll:0"};
        QTest::newRow("pack with too little spacing")
            << QStringList{"pack", job, "--out", path("out"), "--margin", "1"};
        QTest::newRow("pack with an unknown feed edge")
            << QStringList{"pack", job, "--out", path("out"), "--feed", "corner"};
        for (const QStringList& command :
             {QStringList{"run", job, "--out", path("out")},
              QStringList{"optimize", job, "--immersions", "1"},
              QStringList{"print", job, "--to", path("out.pdf")}, QStringList{"cost", job},
              QStringList{"pack", job, "--out", path("out")}, QStringList{"bench"},
              QStringList{"validate", "--physics"}, QStringList{"validate", "--sheet", job}}) {
            QTest::addRow("no such solver for %s", qPrintable(command.join(' ')))
                << command + QStringList{"--solver", "abacus"};
        }
        QTest::newRow("no such outputs")
            << QStringList{"run", job, "--out", path("out"), "--outputs", "Nothing"};
        QTest::newRow("no such port") << QStringList{"serve", path("spool"), "--listen", "70000"};
        QTest::newRow("tiles in a TIFF")
            << QStringList{"print", job, "--to", path("out.tif"), "--tile-paper", "A4"};
        QTest::newRow("no out") << QStringList{"run", job};
        QTest::newRow("option without value") << QStringList{"run", job, "--out"};
        QTest::newRow("set without value") << QStringList{"info", job, "--set", "film.points"};
        QTest::newRow("set unknown") << QStringList{"info", job, "--set", "film.pionts=3x3"};
        QTest::newRow("1 × 1 points")
            << QStringList{"run", job, "--out", path("out"), "--set", "film.points=1x1"};
        QTest::newRow("100,000 × 100,000 points")
            << QStringList{"run", job, "--out", path("out"), "--set", "film.points=100000x100000"};
        QTest::newRow("dpi") << QStringList{"run", job, "--out", path("out"), "--dpi", "many"};
        QTest::newRow("threads") << QStringList{"run", job, "--out", path("out"), "--threads", "0"};
        QTest::newRow("rows") << QStringList{"bench", "--rows", "9"};
        QTest::newRow("one argument too many") << QStringList{"solvers", "all"};
        QTest::newRow("new without a model") << QStringList{"new", path("out")};
        QTest::newRow("empty project name") << QStringList{"new", "", "--model", path("ball.obj")};
        QTest::newRow("size") << newWith({"--size-mm", "-3"});
        QTest::newRow("a model and a jig") << newWith({"--jig", path("ball.obj")});
        QTest::newRow("jig part without a height")
            << QStringList{"new", path("out"), "--jig", path("ball.obj") + ",height=-1"};
        QTest::newRow("jig part with an unknown key")
            << QStringList{"new", path("out"), "--jig", path("ball.obj") + ",offset=1;0,foo=1"};
        QTest::newRow("jig part with a key twice") << QStringList{
            "new", path("out"), "--jig", path("ball.obj") + ",offset=1;0,height=2,offset=2;0"};
        QTest::newRow("immersion with a key twice")
            << newWith({"--immersion", "name=A,offset=1;0,name=B"});
        QTest::newRow("--size-mm with a jig")
            << QStringList{"new", path("out"), "--size-mm", "9", "--jig", path("ball.obj")};
        QTest::newRow("preset") << newWith({"--preset", "paper-1999"});
        QTest::newRow("immersion") << newWith({"--immersion", "upside down"});
        QTest::newRow("immersion key") << newWith({"--immersion", "speed=3"});
        QTest::newRow("immersion rotation") << newWith({"--immersion", "rotation=1;2"});
        QTest::newRow("three immersions")
            << newWith({"--immersion", "name=A", "--immersion", "name=B", "--immersion", "name=C"});
        QTest::newRow("triangles of a model that is not from CAD")
            << newWith({"--set", "model.tessellation_mm=0.01"});
        QTest::newRow("unknown key in a list of marks")
            << QStringList{"info", job, "--set", R"(masks=[{"extent":"stroke","radius":12}])"};
        QTest::newRow("artwork set without --set") << QStringList{"artwork", "set", job, "1"};
    }
    void cli_wrongUsage_exitCodeIsTwo() { refused(2); }

    void cli_optionWithoutEffect_isRefused_data() {
        QTest::addColumn<QStringList>("arguments");
        const QString job = path("ball.dipw");
        const auto row = [](const QStringList& arguments) {
            QTest::newRow(qPrintable(arguments.mid(0, 2).join(' ') + ' ' + arguments.last()))
                << arguments;
        };
        row({"profile", "use", "film", firstFilm(), job, "--set", "swell=1.5x1.5"});
        row({"profile", "list", "--icc", path("file")});
        row({"profile", "show", "film", firstFilm(), "--json"});
        row({"artwork", "list", job, "--on", "Ball"});
        row({"artwork", "remove", job, "1", "--set", "turn_deg=1"});
        row({"validate", "--physics", "--set", "film.swell=1x1"});
        row({"validate", job, "--maps", path("out")});
        row({"cost", job, "--turn"});
        row({"cost", job, "--spacing", "3"});
        row({"print", "--history", "--copies", "3"});
        row({"print", "--printers", "--history"});
        row({"calibrate", "card", "--to", path("card.pdf"), "--lot", "7"});
        row({"inspect", "film", path("ball.png"), "--out", path("out"), "--places", path("file")});
        row({"inspect", "part", path("ball.png"), "--out", path("out"), "--time", "3"});
        row({"inspect", "part", path("ball.png"), "--out", path("out"), "--correct", "1"});
        row({"inspect", "part", path("ball.png"), "--out", path("out"), "--keep-camera"});
        row(newWith({"--immersion", "angle=30"}));
        row(newWith({"--immersion", "path=tilt,radius=10"}));
    }
    void cli_optionWithoutEffect_isRefused() {
        refused(2);
        QFETCH(QStringList, arguments);
        QVERIFY2(cli(arguments).err.contains("has no effect"), qPrintable(arguments.join(' ')));
    }

    void cli_failure_exitCodeIsOne_data() {
        QTest::addColumn<QStringList>("arguments");
        const QString job = path("ball.dipw");
        for (const char* model : {"missing.obj", "empty.obj", "picture.obj", "text.stl", "cut.stl",
                                  "points.obj", "nan.obj", "flat.obj"}) {
            QTest::newRow(model) << QStringList{"new", path("out"), "--model", path(model)};
        }
        QTest::newRow("a file outside")
            << QStringList{"new", path("out"), "--model", path("deep/outside.obj")};
        for (const char* texture :
             {"missing.png", "empty.png", "text.png", "none.png", "vast.png"}) {
            QTest::newRow(texture) << newWith({"--texture", path(texture)});
            QTest::newRow(QByteArray("film image ") + texture)
                << QStringList{"run", job, "--out", path("out"), "--film-image", path(texture)};
        }
        for (const char* project : {"missing.dipw", "empty.dipw", "cut.dipw", "text.dipw"}) {
            QTest::newRow(project) << QStringList{"run", path(project), "--out", path("out")};
            QTest::newRow(QByteArray("info ") + project) << QStringList{"info", path(project)};
        }
        QTest::newRow("path that cannot be travelled")
            << newWith({"--immersion", "name=A,path=tilt,angle=89"});
        QTest::newRow("path with the film of the paper")
            << newWith({"--preset", "paper-2020", "--immersion", "name=A,path=tilt,angle=20"});
        QTest::newRow("no place for the project")
            << QStringList{"new", path("nowhere/job.dipw"), "--model", path("ball.obj")};
        QTest::newRow("the film is missed") << QStringList{
            "run", job, "--out", path("out"), "--set", "immersions[0].offset_mm=400;0"};
        QTest::newRow("the paper is too small") << QStringList{
            "run", job, "--out", path("out"), "--set", "sheet.paper=A4", "--set", "film.preset=A3"};
        QTest::newRow("out is a file") << QStringList{"run", job, "--out", path("file")};
        QTest::newRow("out is below a file") << QStringList{"run", job, "--out", path("file/out")};
    }
    void cli_failure_exitCodeIsOne() { refused(1); }

    void new_allowOutside_readsFilesOutsideModelFolder() {
        const Outcome outcome = cli(
            {"new", path("allowed.dipw"), "--model", path("deep/outside.obj"), "--allow-outside"});
        QVERIFY2(outcome.exitCode == 0, outcome.err);
        QVERIFY(QFile::remove(path("allowed.dipw")));
    }

#ifndef _WIN32 // moc knows _WIN32, but not Q_OS_UNIX
    // A file size limit simulates a full disk: a write fails in the middle of a file.
    void cli_fullDisk_leavesNothingBehind_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("blocks");
        QTest::newRow("new") << newWith({}) << "8";
        const QStringList run{"run",   path("ball.dipw"),   "--out", path("out"),
                              "--set", "film.points=41x58", "--set", "body.sdf_resolution=64"};
        for (const char* blocks : {"8", "64", "128", "512"}) {
            QTest::newRow(QByteArray("run ") + blocks) << run << QString(blocks);
        }
    }
    void cli_fullDisk_leavesNothingBehind() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, blocks);
        const QSet<QString> before = everythingIn(folder_.path());
        const Outcome outcome = program(
            "/bin/sh",
            QStringList{"-c", "ulimit -f \"$0\"; exec \"$@\"", blocks, cliPath()} + arguments);
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.errorLines().size() == 1, outcome.err);
        QVERIFY2(outcome.err.contains("too large"), outcome.err); // the system's reason
        QCOMPARE(everythingIn(folder_.path()), before);
    }

    // Tests a device from which reading never ends, and a pipe to which nobody writes.
    void cli_deviceOrPipeAsFile_isRefusedAtOnce_data() {
        QTest::addColumn<QStringList>("arguments");
        const QString pipe = path("pipe"), job = path("ball.dipw");
        QCOMPARE(mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
        const QStringList run{"run", job, "--out", path("out")};
        for (const QString& file : {QString("/dev/zero"), pipe}) {
            const auto row = [&](const char* what, const QStringList& arguments) {
                QTest::addRow("%s of %s", what, qPrintable(QFileInfo(file).fileName()))
                    << arguments;
            };
            row("profile", {"profile", "import", file});
            row("ICC profile", {"profile", "set", "printer", "Endless", "--icc", file});
            row("readings", {"profile", "wedge", "Endless", file});
            row("project", {"info", file});
            row("project that gets a profile", {"profile", "use", "film", "Standard", file});
            row("new project file", {"new", file, "--model", path("ball.obj")});
            row("model", {"new", path("out"), "--model", file});
            row("texture", newWith({"--texture", file}));
            row("film image", run + QStringList{"--film-image", file});
            row("motion template", run + QStringList{"--motion-template", file});
            row("part of a search", {"optimize", job, "--immersions", "1", "--merge", file});
            row("picture", {"artwork", "add", job, "picture", file});
        }
    }
    void cli_deviceOrPipeAsFile_isRefusedAtOnce() {
        refused(1);
    }

    void profileImport_fileTooLarge_isRefused() {
        QFile file(path("large.json"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.resize(qint64(1) << 30));
        const Outcome outcome = cli({"profile", "import", path("large.json")});
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.err.contains("larger than"), outcome.err);
        QVERIFY(file.remove());
    }

    void profileExport_ontoProject_isRefused() {
        const QByteArray project = bytesOf(path("ball.dipw"));
        const Outcome outcome = cli({"profile", "export", "film", firstFilm(), path("ball.dipw")});
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.errorLines().size() == 1 && outcome.err.contains("not replaced"),
                 outcome.err);
        QCOMPARE(bytesOf(path("ball.dipw")), project);
        // The second export replaces the profile of the first.
        for (int time = 0; time < 2; ++time) {
            QCOMPARE(cli({"profile", "export", "film", firstFilm(), path("film.json")}).exitCode,
                     0);
        }
        QVERIFY(QFile::remove(path("film.json")));
    }

    // A wrong name must not cost a file of another kind.
    void cli_fileOfAnotherKind_isKept_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("file");
        const QString ball = path("ball.dipw");
        QTest::newRow("cost table onto a project")
            << QStringList{"cost", ball, "--csv", path("kept.dipw")} << "kept.dipw";
        QTest::newRow("project onto a picture")
            << QStringList{"new", path("kept.png"), "--model", path("ball.obj")} << "kept.png";
        QTest::newRow("wedge beside filled-in readings")
            << QStringList{"calibrate", "wedge", "--to", path("kept.pdf")} << "kept.csv";
        for (const QString file : {"kept.pdf", "kept.tif"}) {
            QTest::newRow(qPrintable("sheet onto " + file))
                << QStringList{"print", ball, "--to", path(file)} << file;
        }
        QTest::newRow("second film onto a file")
            << QStringList{"pack", ball + ":3", "--to", path("films.pdf")} << "films-2.pdf";
        QTest::newRow("rulers onto a file")
            << QStringList{"calibrate", "--profile", "P", "--to", path("kept.pdf")} << "kept.pdf";
    }

    void cli_fileOfAnotherKind_isKept() {
        QFETCH(QString, file);
        const QByteArray content = bytesOf(path(file.endsWith("png") ? "ball.png" : "ball.dipw"));
        writeFile(path(file), content);
        refused(1);
        QCOMPARE(bytesOf(path(file)), content);
    }

    void info_outputNotWritable_exitCodeIsOne() {
        const Outcome outcome = program(
            "/bin/sh", {"-c", "exec \"$0\" info \"$1\" > /dev/full", cliPath(), path("ball.dipw")});
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.errorLines().size() == 1, outcome.err);
    }

    // A preloaded libminizip has functions with the same names as QuaZip's. QuaZip then packs into
    // a file with a random name, here in a separate folder, and reports success.
    void new_archiveNotWritable_keepsOldProject() {
#ifdef Q_OS_LINUX
        const QTemporaryDir rubbish;
        const QByteArray before = bytesOf(path("ball.dipw"));
        const Outcome outcome = program(
            "/bin/sh",
            {"-c",
             // The address sanitizer must accept that it is not loaded first.
             "cd \"$0\" && export ASAN_OPTIONS=$ASAN_OPTIONS:verify_asan_link_order=0 && "
             "LD_PRELOAD=libminizip.so.1 exec \"$@\"",
             rubbish.path(), cliPath(), "new", path("ball.dipw"), "--model", path("ball.obj")});
        QVERIFY2(outcome.exitCode == 1, outcome.out + outcome.err);
        QVERIFY2(outcome.err.contains("cannot be packed"), outcome.err);
        QCOMPARE(bytesOf(path("ball.dipw")), before);
#endif
    }
#endif

private:
    QString path(const QString& name) const {
        return folder_.filePath(name);
    }
    QStringList newWith(const QStringList& options) const {
        return QStringList{"new", path("out"), "--model", path("ball.obj")} + options;
    }

    // Returns the name of an existing film profile.
    static QString firstFilm() {
        for (const QByteArray& line : cli({"profile", "list"}).out.split('\n')) {
            if (line.startsWith("film ")) {
                return QString::fromUtf8(line).section(" (", 0, 0).mid(5).trimmed();
            }
        }
        return {};
    }

    void refused(int exitCode) {
        QFETCH(QStringList, arguments);
        const QSet<QString> before = everythingIn(folder_.path());
        const Outcome outcome = cli(arguments);
        QVERIFY2(outcome.exitCode == exitCode, outcome.out + outcome.err);
        const QList<QByteArray> errors = outcome.errorLines();
        QVERIFY2(errors.size() == 1, outcome.err);
        // An error reads "Sentence (place)" and contains nothing of the program's code.
        QVERIFY2(errors.first().endsWith(')') && errors.first().contains(" ("), errors.first());
        QVERIFY2(!errors.first().contains("std::"), errors.first());
        QCOMPARE(everythingIn(folder_.path()), before);
    }

    QTemporaryDir folder_, cache_;
};

QTEST_GUILESS_MAIN(BadInputTest)
#include "BadInputTest.moc"
