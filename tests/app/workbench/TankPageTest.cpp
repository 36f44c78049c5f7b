// Works the tank-side page by key presses: step by step, back, pause, closed and opened again. The
// clock is the test's own.
// DIPWRIGHT_PICTURES=FOLDER saves pictures of the page.
#include "workbench/tank/TankPage.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFontMetrics>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

using namespace dipwright;

namespace {

TankJob twoDips(const QString& number) {
    TankJob job{QStringLiteral("Turtle"), {}, number, {}};
    for (const int dip : {1, 2}) {
        job.tasks.push_back({dip, TankStep::Soak, QStringLiteral("Soak"),
                             QStringLiteral("Soak the film: 60 s"), Seconds(60)});
        job.tasks.push_back({dip,
                             TankStep::Compare,
                             QStringLiteral("Compare the part"),
                             QStringLiteral("Compare the part with the picture"),
                             {}});
    }
    return job;
}

// A page with the test's clock.
struct Desk {
    double seconds = 1000;
    std::unique_ptr<TankPage> page;

    explicit Desk(std::vector<TankJob> jobs) { open(std::move(jobs)); }
    void open(std::vector<TankJob> jobs) {
        page = std::make_unique<TankPage>(std::move(jobs), [this] { return seconds; });
        page->resize(1024, 700);
        page->show();
        page->activateWindow();
        page->setFocus();
    }
    void press(Qt::Key key) const { QTest::keyClick(page.get(), key); }
    QString text(const char* name) const {
        return page->findChild<QLabel*>(QLatin1String(name))->text();
    }
};

void keepPicture(QWidget& widget, const QString& name) {
    const QString folder = qEnvironmentVariable("DIPWRIGHT_PICTURES");
    if (!folder.isEmpty()) {
        QDir().mkpath(folder);
        widget.grab().save(QStringLiteral("%1/%2.png").arg(folder, name));
    }
}

} // namespace

class TankPageTest : public QObject {
    Q_OBJECT

private slots:
    void init() { QSettings().remove(QStringLiteral("tank")); }

    void tankPage_spaceBar_goesThroughAllSteps() {
        Desk desk({twoDips("a")});
        std::vector<TankTime> times;
        connect(desk.page.get(), &TankPage::runFinished, this,
                [&](const TankJob&, const std::vector<TankTime>& all) { times = all; });
        QCOMPARE(desk.text("tankTitle"), QStringLiteral("Soak"));
        QTRY_COMPARE(desk.text("tankTime"), QStringLiteral("1:00"));
        QCOMPARE(desk.text("tankNext"), QStringLiteral("Next: Compare the part"));
        desk.seconds += 48.5;
        QTRY_COMPARE(desk.text("tankTime"), QStringLiteral("0:12"));
        desk.seconds += 20;
        QTRY_COMPARE(desk.text("tankTime"), QStringLiteral("+0:08"));
        desk.press(Qt::Key_Space);
        QCOMPARE(desk.text("tankTitle"), QStringLiteral("Compare the part"));
        desk.seconds += 5;
        QTRY_COMPARE(desk.text("tankTime"),
                     QStringLiteral("0:05")); // no time is planned: it counts up
        keepPicture(*desk.page, QStringLiteral("tank-step"));
        for (int step = 0; step < 3; ++step) {
            QVERIFY(times.empty());
            desk.press(Qt::Key_Space);
        }
        QCOMPARE(times.size(), std::size_t(4));
        QCOMPARE(times[0].took, Seconds(68.5));
        QCOMPARE(*times[0].planned, Seconds(60));
        QVERIFY(!times[1].planned);
        QCOMPARE(times[3].dip, 2);
        QVERIFY(!desk.page->work().task());
        desk.press(Qt::Key_Space); // the next run
        QCOMPARE(desk.text("tankTitle"), QStringLiteral("Soak"));
        QVERIFY(desk.text("tankWhere").contains(QStringLiteral("run 2")));
    }

    void tankPage_back_forgetsTheStep() {
        Desk desk({twoDips("a")});
        desk.seconds += 30;
        desk.press(Qt::Key_Space);
        desk.press(Qt::Key_Left);
        QCOMPARE(desk.text("tankTitle"), QStringLiteral("Soak"));
        QTRY_COMPARE(desk.text("tankTime"), QStringLiteral("1:00"));
        QVERIFY(!desk.page->findChild<QPushButton*>("tankBack")->isEnabled());
    }

    void tankPage_pause_stopsTheClock() {
        Desk desk({twoDips("a")});
        desk.seconds += 10;
        desk.press(Qt::Key_P);
        desk.seconds += 500;
        QTRY_COMPARE(desk.text("tankTime"), QStringLiteral("0:50"));
        QVERIFY(desk.text("tankTitle").contains(QStringLiteral("Paused")));
        desk.press(Qt::Key_P);
        desk.seconds += 5;
        QTRY_COMPARE(desk.text("tankTime"), QStringLiteral("0:45"));
    }

    void tankPage_pointer_worksAsTheKeys() {
        Desk desk({twoDips("a")});
        const auto click = [&](const char* name) {
            QTest::mouseClick(desk.page->findChild<QPushButton*>(QLatin1String(name)),
                              Qt::LeftButton);
        };
        click("tankDone");
        QCOMPARE(desk.page->work().taskNumber(), std::size_t(1));
        click("tankBack");
        QCOMPARE(desk.page->work().taskNumber(), std::size_t(0));
        click("tankPause");
        QVERIFY(desk.page->work().isPaused());
        desk.press(Qt::Key_Space); // the space bar still belongs to the page
        QCOMPARE(desk.page->work().taskNumber(), std::size_t(1));
    }

    void tankPage_closedAndOpened_continues() {
        Desk desk({twoDips("a")});
        desk.seconds += 62;
        desk.press(Qt::Key_Space);
        desk.press(Qt::Key_Space);
        desk.seconds += 12;
        desk.press(Qt::Key_P);
        desk.press(Qt::Key_Escape);
        QVERIFY(!desk.page->isVisible());
        desk.seconds = 0; // as after a restart of the computer
        desk.open({twoDips("a")});
        QCOMPARE(desk.page->work().taskNumber(), std::size_t(2));
        QVERIFY(desk.page->work().isPaused());
        QTRY_COMPARE(desk.text("tankTime"), QStringLiteral("0:48"));
        std::vector<TankTime> times;
        connect(desk.page.get(), &TankPage::runFinished, this,
                [&](const TankJob&, const std::vector<TankTime>& all) { times = all; });
        desk.press(Qt::Key_Space);
        desk.press(Qt::Key_Space);
        QCOMPARE(times.size(), std::size_t(4));
        QCOMPARE(times[0].took, Seconds(62));
        desk.open({twoDips("b")}); // another job begins anew
        QCOMPARE(desk.page->work().taskNumber(), std::size_t(0));
    }

    void tankPage_queue_doesOneJobAfterTheOther() {
        TankJob other = twoDips("b");
        other.project = QStringLiteral("Koala");
        Desk desk({twoDips("a"), other});
        QVERIFY(desk.text("tankWhere").contains(QStringLiteral("job 1 of 2")));
        for (int step = 0; step < 4; ++step) {
            desk.press(Qt::Key_Space);
        }
        QVERIFY(desk.text("tankWhere").startsWith(QStringLiteral("Koala")));
        QVERIFY(desk.text("tankWhere").contains(QStringLiteral("job 2 of 2")));
    }

    void tankPage_everySize_lettersFit() {
        TankJob job = twoDips("a");
        job.tasks.front().title = QStringLiteral("Aktivator sprühen und warten");
        job.tasks.front().text =
            QStringLiteral("0 s: (10; 20; 30) mm, (0°; 0°; 15°) · ").repeated(16);
        Desk desk({job});
        for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(2560, 1440)}) {
            desk.page->resize(size);
            QCoreApplication::processEvents();
            QCOMPARE(desk.page->size(), size);
            auto* title = desk.page->findChild<QLabel*>("tankTitle");
            QVERIFY(title->font().pixelSize() >= size.height() / 12);
            for (const char* name : {"tankTitle", "tankText", "tankNext"}) {
                const auto* label = desk.page->findChild<QLabel*>(QLatin1String(name));
                const QRect needed = QFontMetrics(label->font())
                                         .boundingRect(QRect(0, 0, label->width(), 10'000),
                                                       Qt::TextWordWrap, label->text());
                QVERIFY2(needed.height() <= label->height(), name);
            }
        }
    }
};

int main(int argc, char** argv) {
    QTemporaryDir home;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Dipwright"));
    TankPageTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "TankPageTest.moc"
