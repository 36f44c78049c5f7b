// Measures how long the window blocks: the longest times between two turns of its event loop while
// a project opens, a dip runs and its results arrive. Also measures how soon a cancelled dip stops.
//
//   window_heartbeat [--points=COLUMNSxROWS] [--size=WIDTHxHEIGHT] [--without-view] PROJECT.dipw
//
// Finds the solvers in DIPWRIGHT_PLUGIN_PATH.
//
// "Most work" is the largest processor time of one turn of the event loop. On a busy machine it is
// more reliable than wall time. With --without-view nothing is drawn, so a slow OpenGL does not
// count.

#include "WindowDriver.h"

#include "bench/Heartbeat.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>

using namespace dipwright;
using bench::Heartbeat;

namespace {

void measureCancel(MainWindow& window, const WindowDriver& driver) {
    window.document()->edit({}, {},
                            [](Project& project) { project.process.margin = Millimetres(3); });
    QSignalSpy stopped(&window.session(), &DipSession::stopped);
    driver.trigger("run");
    QTest::qWait(2000); // until the dip is half done
    QElapsedTimer clock;
    clock.start();
    driver.trigger("cancel");
    const qint64 answered = clock.elapsed();
    const bool stoppedAtOnce = !stopped.isEmpty();
    const QAction* cancel = driver.action("cancel");
    const bool ended = QTest::qWaitFor([cancel] { return !cancel->isEnabled(); }, 60'000);
    std::printf("cancelled: the window answers after %lld ms%s, the solver stops after %lld ms%s\n",
                static_cast<long long>(answered), stoppedAtOnce ? "" : " (but runs on)",
                static_cast<long long>(clock.elapsed()), ended ? "" : " (it does not)");
}

} // namespace

int main(int argc, char* argv[]) {
    const WindowApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addOptions(
        {{QStringLiteral("points"), {}, QStringLiteral("COLUMNSxROWS"), QStringLiteral("280x396")},
         {QStringLiteral("size"), {}, QStringLiteral("WIDTHxHEIGHT"), QStringLiteral("1280x800")},
         {QStringLiteral("without-view"), {}}});
    parser.addPositionalArgument(QStringLiteral("PROJECT"), {});
    parser.process(*qApp);
    const QStringList points = parser.value(QStringLiteral("points")).split(QLatin1Char('x'));
    const QStringList size = parser.value(QStringLiteral("size")).split(QLatin1Char('x'));

    Workbench workbench(application.home());
    Preferences preferences = workbench.preferences();
    preferences.liveUpdate = false;
    workbench.setPreferences(preferences);
    MainWindow window(workbench);
    window.resize(size.value(0).toInt(), size.value(1).toInt());
    window.show();
    WindowDriver driver(window);
    Heartbeat heart;
    heart.start();
    if (points.size() != 2 || size.size() != 2 ||
        !driver.open(parser.positionalArguments().value(0))) {
        std::fputs("The project could not be opened\n", stderr);
        return 1;
    }
    window.view().setVisible(!parser.isSet(QStringLiteral("without-view")));
    QTest::qWait(1000);
    heart.print("opening");
    window.document()->edit({}, {}, [&points](Project& project) {
        project.film.columns = points[0].toInt();
        project.film.rows = points[1].toInt();
        project.immersions.resize(1);
    });
    QTest::qWait(500);
    heart.start();
    bool arrived = false;
    QObject::connect(&window.session(), &DipSession::finished, [&] { arrived = true; });
    driver.trigger("run");
    while (window.session().isRunning()) {
        QTest::qWait(5);
    }
    QTest::qWait(500); // includes the arrival of the results
    heart.print("dipping");
    if (!arrived) {
        std::fputs("The dip did not end\n", stderr);
        return 1;
    }
    heart.start();
    QTest::qWait(1000);
    heart.print("afterwards");
    measureCancel(window, driver);
    return 0;
}
