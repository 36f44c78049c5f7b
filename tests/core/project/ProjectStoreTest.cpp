// Project files: every save leaves a whole file, and hostile files are refused.
#include "HostileZip.h"
#include "SampleProject.h"
#include "TestFiles.h"
#include "TestFolders.h"
#include "artwork/EditArtwork.h"
#include "model/TexturedMesh.h"

#include "base/Error.h"
#include "project/ProjectStore.h"
#include "project/Schema.h"

#include <QBuffer>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>

using namespace dipwright;
using namespace dipwright::test;

namespace {

const QString savingArgument = QStringLiteral("--save-until-killed");

QString refusal(const QString& path) {
    try {
        loadProject(path);
    } catch (const Error& error) {
        return error.sentence();
    }
    return {};
}

QJsonObject documentOf(const QList<ZipEntry>& entries) {
    for (const ZipEntry& entry : entries) {
        if (entry.name == QLatin1String("project.json")) {
            return QJsonDocument::fromJson(entry.contents).object();
        }
    }
    return {};
}

// Saves two projects alternately to the same file and prints the number of each save, until the
// process is killed.
[[noreturn]] void saveUntilKilled(const QString& path) {
    Project project = sampleProject();
    QTextStream out(stdout);
    for (int turn = 0;; ++turn) {
        project.name = turn % 2 == 0 ? QStringLiteral("even") : QStringLiteral("odd");
        saveProject(project, path);
        out << turn << '\n' << Qt::flush;
    }
}

} // namespace

class ProjectStoreTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        saveProject(sampleProject(), path("good.dipw"));
        good_ = bytesOf(path("good.dipw"));
        entries_ = entriesOf(path("good.dipw"));
    }

    void loadProject_savedProject_isTheSame() {
        const Project project = loadProject(path("good.dipw"));
        Project expected = sampleProject();
        expected.modelOrigin.sha256 = project.modelOrigin.sha256;
        QVERIFY(isSame(project, expected));
        QCOMPARE(project.modelOrigin.sha256.size(), 64);
        QCOMPARE(project.model->textures.front(), expected.model->textures.front());
    }

    void solverOfProject_savedProject_readsOnlyTheSolver() {
        Project project = sampleProject();
        project.process.solver = QStringLiteral("pbd-cpu");
        saveProject(project, path("solver.dipw"));
        QCOMPARE(solverOfProject(path("solver.dipw")), QStringLiteral("pbd-cpu"));
        writeFile(path("none.dipw"), zip(withDocument("{}")));
        QCOMPARE(solverOfProject(path("none.dipw")), QStringLiteral("auto"));
        QVERIFY_EXCEPTION_THROWN(solverOfProject(path("missing.dipw")), Error);
    }

    void saveProject_mimeType_isFirstAndUncompressed() {
        QCOMPARE(good_.mid(30, 8), QByteArray("mimetype"));
        QCOMPARE(good_.mid(38, 33), QByteArray("application/vnd.dipwright.project"));
    }

    void saveProject_modelAndPicture_areInside() {
        const QJsonObject model = documentOf(entries_)["model"].toObject();
        QStringList names;
        for (const ZipEntry& entry : entries_) {
            names.append(entry.name);
        }
        QVERIFY(names.contains(model["mesh"].toString()));
        QVERIFY(names.contains(model["texture"].toString()));
        QVERIFY(model["mesh"].toString().startsWith("assets/"));
        QVERIFY(model["texture"].toString().startsWith("assets/"));
    }

    void saveProject_unreadableProject_isRefused() {
        Project project = sampleProject();
        saveProject(project, path("kept.dipw"));
        const QByteArray before = bytesOf(path("kept.dipw"));
        project.unknownEntries["zeros"] =
            QByteArray(64 << 20, '\0'); // compresses to nearly nothing
        QVERIFY_EXCEPTION_THROWN(saveProject(project, path("kept.dipw")), Error);
        auto model = std::make_shared<TexturedMesh>(*sampleProject().model);
        model->textures.resize(1001, model->textures.front());
        project = sampleProject();
        project.model = model;
        QVERIFY_EXCEPTION_THROWN(saveProject(project, path("kept.dipw")), Error);
        QCOMPARE(bytesOf(path("kept.dipw")), before);
    }

    void loadProject_tooManyOrNestedValues_areRefused() {
        const auto with = [this](const QByteArray& value) {
            writeFile(path("values.dipw"), zip(withDocument("{\"zz\":" + value + "}")));
            return refusal(path("values.dipw"));
        };
        QVERIFY(with(QByteArray(40, '[') + QByteArray(40, ']')).contains("32 levels"));
        QVERIFY(with("[" + QByteArray("[0],").repeated(600'000) + "0]").contains("1 million"));
        QVERIFY(with("\"[[[[" + QByteArray("[\\\",").repeated(600'000) + "\"")
                    .contains("not a Dipwright project"));
    }

    void loadProject_controlCharactersInName_areReplaced() {
        writeFile(path("name.dipw"), zip(withDocument(renamed("A\nFake: line\rX\x1b[31m"))));
        QCOMPARE(loadProject(path("name.dipw")).name, QStringLiteral("A Fake: line X [31m"));
        // Characters that reverse the order of letters are replaced visibly.
        writeFile(path("turned.dipw"), zip(withDocument(renamed("abc\u202edef"))));
        QCOMPARE(loadProject(path("turned.dipw")).name, QStringLiteral("abc\uFFFDdef"));
    }

    // "textures" is for models with several pictures. Other programs write and change "texture".
    void loadProject_textureKey_namesThePicture() {
        writeFile(path("one.dipw"), zip(withDocument(changed("textures", QJsonValue::Undefined))));
        QCOMPARE(loadProject(path("one.dipw")).model->textures, sampleProject().model->textures);
        QByteArray red;
        QBuffer buffer(&red);
        QImage picture(4, 4, QImage::Format_RGB32);
        picture.fill(Qt::red);
        QVERIFY(picture.save(&buffer, "PNG"));
        auto entries = withDocument(changed("texture", "assets/red.png"));
        entries.push_back({"assets/red.png", red});
        writeFile(path("red.dipw"), zip(entries));
        QCOMPARE(loadProject(path("red.dipw")).model->textures.front().size(), QSize(4, 4));
    }

    void saveProject_unknownEntries_areKept() {
        auto entries = plus("results/run.txt", "yesterday");
        entries.push_back({"assets/notes.bin", QByteArray("\0\1\2", 3)});
        writeFile(path("more.dipw"), zip(entries));
        saveProject(loadProject(path("more.dipw")), path("more.dipw"));
        const Project project = loadProject(path("more.dipw"));
        QCOMPARE(project.unknownEntries.size(), 2U);
        QCOMPARE(project.unknownEntries.at("results/run.txt"), QByteArray("yesterday"));
        QCOMPARE(project.unknownEntries.at("assets/notes.bin"), QByteArray("\0\1\2", 3));
        saveProject(sampleProject(), path("plain.dipw"));
        QVERIFY(loadProject(path("plain.dipw")).unknownEntries.empty());
    }

    void saveProject_sameProject_givesTheSameBytes() {
        saveProject(sampleProject(), path("again.dipw"));
        QCOMPARE(bytesOf(path("again.dipw")), good_);
        saveProject(loadProject(path("again.dipw")), path("again.dipw"));
        QCOMPARE(bytesOf(path("again.dipw")), good_);
    }

    void saveProject_leavesNoOtherFiles() {
        QTemporaryDir folder;
        saveProject(sampleProject(), folder.filePath("job.dipw"));
        saveProject(sampleProject(), folder.filePath("job.dipw"));
        const QDir::Filters all = QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot;
        QCOMPARE(QDir(folder.path()).entryList(all), QStringList{"job.dipw"});
    }

    // A picture of one colour with 6000 × 6000 pixels takes a few kilobytes. The pixel limit allows
    // one of them in a file.
    void loadProject_pixelLimit_countsTexturesAndLayersTogether() {
        Project project = sampleProject();
        ArtworkLayer layer = newLayer(LayerKind::Picture, QStringLiteral("logo"));
        layer.picture = artworkPicture(project.model->textures.front());
        project.artwork.layers = {layer};
        saveProject(project, path("layer.dipw"));
        QCOMPARE(loadProject(path("layer.dipw")).artwork.layers.size(), std::size_t(1));
        QByteArray large;
        QBuffer buffer(&large);
        QImage picture(6000, 6000, QImage::Format_Mono);
        picture.fill(1);
        QVERIFY(picture.save(&buffer, "PNG"));
        const auto withLarge = [&](const QString& beginning) {
            auto entries = entriesOf(path("layer.dipw"));
            for (ZipEntry& entry : entries) {
                if (entry.name.startsWith(beginning) && entry.name.endsWith(".png")) {
                    entry.contents = large;
                }
            }
            return zip(entries);
        };
        writeFile(path("one.dipw"), withLarge("assets/texture"));
        QCOMPARE(loadProject(path("one.dipw")).model->textures.front().width(), 6000);
        writeFile(path("two.dipw"), withLarge("assets/"));
        const QString sentence = refusal(path("two.dipw"));
        QVERIFY2(sentence.contains("million pixels"), qPrintable(sentence));

        // A project that could not be opened again is not saved.
        project = loadProject(path("one.dipw"));
        project.artwork.layers.front().picture = artworkPicture(project.model->textures.front());
        QVERIFY_EXCEPTION_THROWN(saveProject(project, path("one.dipw")), Error);
        QCOMPARE(loadProject(path("one.dipw")).artwork.layers.front().picture.image.width(), 16);
    }

    void saveProject_unwritablePlace_isRefused() {
        QVERIFY_EXCEPTION_THROWN(saveProject(sampleProject(), path("nowhere/job.dipw")), Error);
        QVERIFY_EXCEPTION_THROWN(saveProject(sampleProject(), folder_.path()), Error);
    }

    void saveProject_killed_leavesAWholeFile() {
        const QString file = path("killed.dipw");
        saveProject(sampleProject(), file);
        for (int kill = 0; kill < 25; ++kill) {
            QProcess saver;
            saver.start(QCoreApplication::applicationFilePath(), {savingArgument, file});
            QVERIFY(saver.waitForStarted());
            // The saver is killed at an arbitrary moment after some saves.
            for (qint64 seen = 0; seen < 2 * (1 + kill % 7); seen += saver.readAll().size()) {
                QVERIFY(saver.waitForReadyRead());
            }
            saver.kill();
            QVERIFY(saver.waitForFinished());
            const QString name = loadProject(file).name;
            QVERIFY2(name == "even" || name == "odd", qPrintable(name));
        }
    }

    void loadProject_notAProject_isRefused_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("says");
        QTest::newRow("empty") << QByteArray() << "empty";
        QTest::newRow("text") << QByteArray("Dear hydrographer,\n") << "not a Dipwright project";
        QTest::newRow("zeros") << QByteArray(5000, 0) << "not a Dipwright project";
        QTest::newRow("another zip") << zip({{"readme.txt", "hello"}}) << "project.json";
        QTest::newRow("empty zip") << zip({}) << "";
        QTest::newRow("no document") << zip(without("project.json")) << "project.json";
        QTest::newRow("no model") << zip(without("assets/model.dwmodel")) << "model.dwmodel";
        QTest::newRow("no texture") << zip(without("assets/texture-1.png")) << "texture-1.png";
        QTest::newRow("encrypted") << zip(encrypted()) << "encrypted";
        QTest::newRow("parent path") << zip(plus("../../outside.txt", "x")) << "unsafe path";
        QTest::newRow("inner parent path") << zip(plus("assets/../../x", "x")) << "unsafe path";
        QTest::newRow("absolute path") << zip(plus("/etc/outside", "x")) << "unsafe path";
        QTest::newRow("drive") << zip(plus("C:outside", "x")) << "unsafe path";
        QTest::newRow("backslash") << zip(plus("..\\outside", "x")) << "unsafe path";
        QTest::newRow("twice") << zip(plus("project.json", "{}")) << "twice";
        QTest::newRow("bomb") << zip(plus("assets/zeros", QByteArray(64 << 20, 0))) << "unpack";
        QTest::newRow("many entries") << zip(crowd()) << "entries";
        QTest::newRow("not JSON") << zip(withDocument("{\"format\":")) << "damaged at character";
        QTest::newRow("a key twice")
            << zip(withDocument(R"({"film": {"a": [{"b": "b,"}, {"c": 1, "d": {}, "c": 2}]}})"))
            << "film.a[1].c twice";
        QTest::newRow("an array") << zip(withDocument("[]")) << "project.json";
        QTest::newRow("wrong sha256")
            << zip(withDocument(changed("sha256", QString(64, 'a')))) << "sha256";
        QTest::newRow("mesh elsewhere")
            << zip(withDocument(changed("mesh", "../../../etc/passwd"))) << "does not contain";
        QTest::newRow("texture is no picture")
            << zip(withDocument(changed("texture", "mimetype"))) << "picture";
        QTest::newRow("no mesh named") << zip(withDocument(changed("mesh", 5))) << "model.mesh";
        QJsonObject newer = documentOf(entries_);
        newer["version"] = 4;
        QTest::newRow("newer") << zip(withDocument(QJsonDocument(newer).toJson())) << "version 4";
    }
    void loadProject_notAProject_isRefused() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, says);
        writeFile(path("bad.dipw"), bytes);
        const QString sentence = refusal(path("bad.dipw"));
        QVERIFY2(sentence.contains(says) && sentence.contains("bad.dipw"), qPrintable(sentence));
        QVERIFY(!sentence.contains('\n'));
    }

    void loadProject_missingFileOrFolder_isRefused() {
        QVERIFY(refusal(path("missing.dipw")).contains("missing.dipw"));
        QVERIFY(refusal(folder_.path()).contains("it is a folder"));
    }

    void loadProject_truncated_isRefused() {
        for (qsizetype length = 1; length < good_.size(); length += 1 + length / 40) {
            writeFile(path("cut.dipw"), good_.left(length));
            QVERIFY2(!refusal(path("cut.dipw")).isEmpty(),
                     qPrintable(QStringLiteral("the first %1 bytes are opened, expected a refusal")
                                    .arg(length)));
        }
    }

    void loadProject_goldenOfEveryVersion_opens() {
        const QDir golden(sourceFolder("/tests/core/project/golden"));
        for (int version = 1; version <= projectVersion; ++version) {
            const Project project =
                loadProject(golden.filePath(QStringLiteral("version-%1.dipw").arg(version)));
            QCOMPARE(project.film.columns, 61);
            QCOMPARE(project.immersions.size(), 2U);
            QVERIFY(!project.model->mesh.triangles.empty());
            QCOMPARE(project.model->textures.size(), 1U);
            QCOMPARE(project.share.enabled, version > 1);
        }
    }

    void loadProject_goldenVersion1_isUnchanged() {
        const Project project = loadProject(QDir(sourceFolder("/tests/core/project/golden"))
                                                .filePath(QStringLiteral("version-1.dipw")));
        QCOMPARE(project.name, QStringLiteral("golden"));
        QCOMPARE(project.immersions[1].rotation[0].value(), 180.0);
        QCOMPARE(project.model->mesh.triangles.size(), 12U);
        QCOMPARE(project.unknown["kept"].toObject()["by"].toString(),
                 QStringLiteral("whoever reads this"));
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }

    QList<ZipEntry> without(const QString& name) const {
        QList<ZipEntry> entries = entries_;
        entries.removeIf([&](const ZipEntry& entry) { return entry.name == name; });
        return entries;
    }
    QList<ZipEntry> plus(const QString& name, const QByteArray& contents) const {
        return QList<ZipEntry>(entries_) << ZipEntry{name, contents};
    }
    QList<ZipEntry> encrypted() const {
        QList<ZipEntry> entries = entries_;
        for (ZipEntry& entry : entries) {
            entry.password = "secret";
        }
        return entries;
    }
    QList<ZipEntry> crowd() const {
        QList<ZipEntry> entries = entries_;
        for (int index = 0; index < 10'001; ++index) {
            entries.append({QStringLiteral("assets/%1").arg(index), {}});
        }
        return entries;
    }
    QList<ZipEntry> withDocument(const QByteArray& json) const {
        QList<ZipEntry> entries = entries_;
        for (ZipEntry& entry : entries) {
            if (entry.name == QLatin1String("project.json")) {
                entry.contents = json;
            }
        }
        return entries;
    }
    // Returns the document with another project name.
    QByteArray renamed(const QString& name) const {
        QJsonObject json = documentOf(entries_);
        json["name"] = name;
        return QJsonDocument(json).toJson();
    }
    QByteArray changed(const QString& key, const QJsonValue& value) const {
        QJsonObject json = documentOf(entries_);
        QJsonObject model = json["model"].toObject();
        model[key] = value;
        json["model"] = model;
        return QJsonDocument(json).toJson();
    }

    QTemporaryDir folder_;
    QByteArray good_;
    QList<ZipEntry> entries_;
};

int main(int argc, char* argv[]) {
    QCoreApplication application(argc, argv);
    if (argc == 3 && savingArgument == QLatin1String(argv[1])) {
        saveUntilKilled(QString::fromLocal8Bit(argv[2]));
    }
    ProjectStoreTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "ProjectStoreTest.moc"
