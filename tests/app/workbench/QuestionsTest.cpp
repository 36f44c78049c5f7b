// Answers the window's questions by clicks: before it overwrites somebody's work, and before it
// reads files outside a model's folder. Also checks that names from files are shown as plain text.
// DIPWRIGHT_PICTURES=FOLDER saves the screen at each question.
#include "Patience.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "disk/FileLock.h"
#include "project/ProjectStore.h"
#include "workbench/main/EditController.h"
#include "workbench/widgets/NoticeBar.h"
#include "workbench/widgets/PlainTexts.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QTableWidget>
#include <QTimer>
#include <QToolTip>

using namespace dipwright;

namespace {

const QString sample = sampleFolder("/tetrahedron.dipw");

void keepScreen(const QString& name) {
    const QString folder = qEnvironmentVariable("DIPWRIGHT_PICTURES");
    if (!folder.isEmpty()) {
        QTest::qWait(500); // until the question is drawn
        QDir().mkpath(folder);
        QGuiApplication::primaryScreen()->grabWindow(0).save(folder + QLatin1Char('/') + name +
                                                             QStringLiteral(".png"));
    }
}

// Returns the button's text without its mnemonic.
QString shownText(const QAbstractButton& button) {
    return button.text().remove(QLatin1Char('&'));
}

bool write(const QString& path, const QByteArray& text) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

// A name that a label with Qt::AutoText would show as a picture from the disk.
const QString misleading = QStringLiteral("<img src='private.png'>");

QList<const QLabel*> labelsWith(const QString& text, const QWidgetList& widgets) {
    QList<const QLabel*> found;
    for (const QWidget* widget : widgets) {
        const auto* label = qobject_cast<const QLabel*>(widget);
        if (label && label->isVisible() && label->text().contains(text)) {
            found.append(label);
        }
    }
    return found;
}

// Returns whether exactly one label shows the text, and shows it as plain text.
bool isShownAsText(const QString& text) {
    const auto labels = labelsWith(text, QApplication::allWidgets());
    return labels.size() == 1 && labels.first()->textFormat() == Qt::PlainText;
}

// Asks the widget for its tool tip, like a resting cursor.
void restOn(QWidget& widget, const QPoint& place) {
    QHelpEvent rest(QEvent::ToolTip, place, widget.mapToGlobal(place));
    QApplication::sendEvent(&widget, &rest);
}

double swellOf(const QString& project) {
    return loadProject(project).film.swellX;
}

} // namespace

class QuestionsTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void lockQuestion_cancelOrOpenAnyway_isFollowed();
    void changedQuestion_cancelOrOverwrite_isFollowed();
    void changedQuestion_saveAs_keepsBothFiles();
    void closeQuestion_fileDeleted_isAskedAndSaveWritesTheFile();
    void outsideQuestion_cancelOrReadFiles_isFollowed();
    void textureFolder_textureThenModelThenNone_isChosen();
    void messages_htmlInName_isShownAsText();
    void toolTips_htmlInName_isShownAsText();
    void toolTips_longText_isShownInLines();
    void screenReader_htmlInName_isReadAsText();

private:
    QString path(const QString& name) const { return folder_->filePath(name); }
    // Clicks on a button of the named question as soon as it is shown. Stores the question's text
    // in questionText_.
    void answer(const QString& name, const QString& button);
    void clickOn(const QMessageBox& question, const QString& button);
    bool isAnswered() const {
        return QTest::qWaitFor([&] { return !asking_; }, patience());
    }
    // Opens and changes the project, then changes the file like another program.
    bool changeFileElsewhere();
    // Writes a model that names a picture outside its folder. Returns its path.
    QString modelNamingOutsideFile() const;

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<MainWindow> window_;
    QString job_;
    bool asking_ = false;
    QString questionText_;
    Qt::TextFormat format_ = Qt::AutoText; // text format of questionText_
};

void QuestionsTest::init() {
    folder_ = std::make_unique<QTemporaryDir>();
    job_ = path(QStringLiteral("job.dipw"));
    QVERIFY(QFile::copy(sample, job_));
    QVERIFY(QFile::setPermissions(job_, QFile::ReadOwner | QFile::WriteOwner));
    workbench_ = std::make_unique<Workbench>(path(QStringLiteral("recovery")));
    window_ = std::make_unique<MainWindow>(*workbench_);
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

void QuestionsTest::cleanup() {
    window_.reset();
    workbench_.reset();
}

void QuestionsTest::answer(const QString& name, const QString& button) {
    asking_ = true;
    questionText_.clear();
    auto* watch = new QTimer(this);
    connect(watch, &QTimer::timeout, this, [=, this] {
        const auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (question && question->objectName() == name) {
            watch->stop();
            clickOn(*question, button);
            asking_ = false;
            watch->deleteLater();
        }
    });
    watch->start(20);
}

void QuestionsTest::clickOn(const QMessageBox& question, const QString& button) {
    questionText_ = question.text() + QLatin1Char('\n') + question.informativeText();
    format_ = question.textFormat();
    keepScreen(question.objectName());
    for (QAbstractButton* offered : question.buttons()) {
        if (shownText(*offered) == button) {
            QTest::mouseClick(offered, Qt::LeftButton);
            return;
        }
    }
    QFAIL(qPrintable(QStringLiteral("the question has no button “%1”").arg(button)));
}

void QuestionsTest::lockQuestion_cancelOrOpenAnyway_isFollowed() {
    FileLock other;
    QVERIFY(other.acquire(job_).acquired);
    answer(QStringLiteral("lockQuestion"), QStringLiteral("Cancel"));
    window_->documents().openProject(job_);
    QVERIFY(isAnswered());
    QVERIFY2(questionText_.contains(QString::number(QCoreApplication::applicationPid())),
             qPrintable(questionText_));
    QVERIFY(!window_->document() || window_->document()->path().isEmpty());

    answer(QStringLiteral("lockQuestion"), QStringLiteral("Open anyway"));
    QVERIFY(WindowDriver(*window_).open(job_));
    QVERIFY(!asking_);
    QCOMPARE(window_->document()->path(), job_);
}

bool QuestionsTest::changeFileElsewhere() {
    if (!WindowDriver(*window_).open(job_)) {
        return false;
    }
    window_->document()->edit({}, {}, [](Project& project) { project.film.swellX = 1.11; });
    Project theirs = loadProject(job_);
    theirs.film.swellX = 1.22;
    saveProject(theirs, job_);
    return window_->document()->isModified();
}

void QuestionsTest::changedQuestion_cancelOrOverwrite_isFollowed() {
    QVERIFY(changeFileElsewhere());
    const WindowDriver driver(*window_);
    answer(QStringLiteral("changedQuestion"), QStringLiteral("Cancel"));
    driver.trigger("save");
    QVERIFY(isAnswered());
    QVERIFY2(questionText_.contains(QStringLiteral("job")), qPrintable(questionText_));
    QCOMPARE(swellOf(job_), 1.22);
    QVERIFY(window_->document()->isModified());

    answer(QStringLiteral("changedQuestion"), QStringLiteral("Overwrite"));
    driver.trigger("save");
    QVERIFY(isAnswered());
    QTRY_VERIFY_WITH_TIMEOUT(!window_->document()->isModified(), patience());
    QCOMPARE(swellOf(job_), 1.11);
}

void QuestionsTest::changedQuestion_saveAs_keepsBothFiles() {
    QVERIFY(changeFileElsewhere());
    const QString mine = path(QStringLiteral("mine.dipw"));
    QTimer choosing;
    connect(&choosing, &QTimer::timeout, this, [&] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        auto* name =
            dialog ? dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit")) : nullptr;
        if (name && name->text() != mine) {
            name->selectAll();
            QTest::keyClicks(name, mine); // this clears the selection in the list
        } else if (name) {                // when the dialog shows the folder
            dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save)->click();
        }
    });
    choosing.start(20);
    answer(QStringLiteral("changedQuestion"), QStringLiteral("Save as…"));
    WindowDriver(*window_).trigger("save");
    QTRY_VERIFY_WITH_TIMEOUT(!window_->document()->isModified(), patience());
    QCOMPARE(swellOf(job_), 1.22);
    QCOMPARE(swellOf(mine), 1.11);
    QCOMPARE(window_->document()->path(), mine);
}

void QuestionsTest::closeQuestion_fileDeleted_isAskedAndSaveWritesTheFile() {
    WindowDriver driver(*window_);
    QVERIFY(driver.open(job_));
    QVERIFY(!driver.action("save")->isEnabled());
    QVERIFY(QFile::remove(job_));
    QEvent activated(QEvent::ActivationChange);
    QApplication::sendEvent(window_.get(), &activated);
    QVERIFY(driver.action("save")->isEnabled());
    auto* notice = driver.find<NoticeBar>("notice");
    QVERIFY(notice->isVisible());
    QVERIFY(driver.save());
    QVERIFY(QFile::exists(job_));
    QVERIFY(!notice->isVisible());
    QVERIFY(!driver.action("save")->isEnabled());

    QVERIFY(QFile::remove(job_));
    answer(QStringLiteral("closeQuestion"), QStringLiteral("Save"));
    QVERIFY(window_->close());
    QVERIFY(isAnswered());
    QVERIFY2(questionText_.contains(QStringLiteral("no longer exists")), qPrintable(questionText_));
    QVERIFY(QFile::exists(job_));
}

void QuestionsTest::textureFolder_textureThenModelThenNone_isChosen() {
    QVERIFY(QDir(folder_->path()).mkpath(QStringLiteral("model")));
    QVERIFY(QDir(folder_->path()).mkpath(QStringLiteral("pictures")));
    ModelOrigin origin;
    QCOMPARE(textureFolder(origin), QString());
    origin.source = path(QStringLiteral("model/plate.obj"));
    QCOMPARE(textureFolder(origin), path(QStringLiteral("model")));
    origin.texture = path(QStringLiteral("pictures/wood.png"));
    QCOMPARE(textureFolder(origin), path(QStringLiteral("pictures")));
    origin.texture = path(QStringLiteral("missing/wood.png"));
    QCOMPARE(textureFolder(origin), path(QStringLiteral("model")));
    origin.source = path(QStringLiteral("missing/plate.obj"));
    QCOMPARE(textureFolder(origin), QString());
}

QString QuestionsTest::modelNamingOutsideFile() const {
    const QString model = path(QStringLiteral("model/plate.obj"));
    QImage picture(8, 8, QImage::Format_RGB32);
    picture.fill(Qt::red);
    const bool made =
        QDir(folder_->path()).mkpath(QStringLiteral("model")) &&
        picture.save(path(QStringLiteral("private.png"))) &&
        write(path(QStringLiteral("model/plate.mtl")), "newmtl skin\nmap_Kd ../private.png\n") &&
        write(model, "mtllib plate.mtl\nusemtl skin\nv 0 0 0\nv 9 0 0\nv 0 0 9\nv 0 9 0\n"
                     "vt 0 0\nvt 1 0\nvt 0 1\n"
                     "f 1/1 2/2 3/3\nf 1/1 4/2 2/3\nf 2/1 4/2 3/3\nf 3/1 4/2 1/3\n");
    return made ? model : QString();
}

void QuestionsTest::outsideQuestion_cancelOrReadFiles_isFollowed() {
    const QString model = modelNamingOutsideFile();
    QVERIFY(!model.isEmpty());
    answer(QStringLiteral("outsideQuestion"), QStringLiteral("Cancel"));
    window_->documents().importModel(model, {}, {});
    QVERIFY(isAnswered());
    QVERIFY2(questionText_.contains(QStringLiteral("private.png")), qPrintable(questionText_));
    QTest::qWait(200);
    QVERIFY(!window_->document() || !window_->document()->project().model);

    answer(QStringLiteral("outsideQuestion"), QStringLiteral("Read files"));
    window_->documents().importModel(model, {}, {});
    QVERIFY(isAnswered());
    const auto hasPicture = [&] {
        const auto* document = window_->document();
        return document && document->project().model &&
               !document->project().model->textures.empty();
    };
    QVERIFY(QTest::qWaitFor(hasPicture, patience()));
    QCOMPARE(window_->document()->project().model->textures.at(0).size(), QSize(8, 8));
}

void QuestionsTest::messages_htmlInName_isShownAsText() {
    answer(QStringLiteral("failure"), QStringLiteral("OK"));
    window_->documents().importModel(path(misleading + QStringLiteral(".obj")), {}, {});
    QVERIFY(isAnswered());
    QVERIFY2(questionText_.contains(misleading), qPrintable(questionText_));
    QCOMPARE(format_, Qt::PlainText);

    QVERIFY(WindowDriver(*window_).open(job_));
    auto* notice = WindowDriver(*window_).find<NoticeBar>("notice");
    notice->say(misleading);
    QVERIFY(QTest::qWaitFor([] { return isShownAsText(misleading); }, patience()));
}

void QuestionsTest::toolTips_htmlInName_isShownAsText() {
    QListWidget list;
    list.setToolTip(misleading);
    auto* item = new QListWidgetItem(QStringLiteral("project"), &list);
    item->setToolTip(misleading + QStringLiteral(" of the item"));
    list.show();
    QVERIFY(QTest::qWaitForWindowExposed(&list));
    restOn(*list.viewport(), list.viewport()->rect().bottomRight() - QPoint(5, 5));
    QVERIFY(QTest::qWaitFor([] { return isShownAsText(misleading); }, patience()));
    restOn(*list.viewport(), list.visualItemRect(item).center());
    QVERIFY(QTest::qWaitFor([item] { return isShownAsText(item->toolTip()); }, patience()));
    QToolTip::hideText();
}

void QuestionsTest::toolTips_longText_isShownInLines() {
    const QString text = QStringLiteral("A tooltip of many words is read in lines. ").repeated(4);
    QTableWidget table(1, 1);
    table.setItem(0, 0, new QTableWidgetItem(QStringLiteral("item")));
    table.setHorizontalHeaderItem(0, new QTableWidgetItem(QStringLiteral("section")));
    table.item(0, 0)->setToolTip(text + QStringLiteral("Item.\nLast line."));
    table.horizontalHeaderItem(0)->setToolTip(text + QStringLiteral("Section."));
    table.setToolTip(text + QStringLiteral("Table."));
    table.show();
    QVERIFY(QTest::qWaitForWindowExposed(&table));
    const auto isShownInLines = [](const QString& tip) {
        return QTest::qWaitFor([&] { return isShownAsText(inLines(tip)); }, patience());
    };
    QWidget& items = *table.viewport();
    restOn(items, table.visualItemRect(table.item(0, 0)).center());
    QVERIFY(isShownInLines(table.item(0, 0)->toolTip()));
    restOn(items, items.rect().bottomRight() - QPoint(5, 5));
    QVERIFY(isShownInLines(table.toolTip()));
    restOn(*table.horizontalHeader()->viewport(), QPoint(10, 10));
    QVERIFY(isShownInLines(table.horizontalHeaderItem(0)->toolTip()));
    QToolTip::hideText();
    for (const QString& line : inLines(table.item(0, 0)->toolTip()).split(u'\n')) {
        QVERIFY(!line.isEmpty() && line.size() <= 70);
    }
    QCOMPARE(inLines(inLines(text)), inLines(text));
}

void QuestionsTest::screenReader_htmlInName_isReadAsText() {
    QLabel label(misleading); // not shown yet
    QCOMPARE(QAccessible::queryAccessibleInterface(&label)->text(QAccessible::Name), misleading);
}

int main(int argc, char** argv) {
    return runWindowTest<QuestionsTest>(argc, argv);
}
#include "QuestionsTest.moc"
