// Measures how soon results appear in the real window while the part is dragged. Turns the part for
// some seconds as a dragged ring does, releases it, and waits for the result.
//
//   live_window [--seconds=N] [--size=WIDTHxHEIGHT] [--pictures=FOLDER] PROJECT.dipw …
//
// Finds the solvers in DIPWRIGHT_PLUGIN_PATH. --pictures saves the window 0.1, 1 and 5 s after the
// release.

#include "WindowDriver.h"

#include "bench/Heartbeat.h"

#include <QCommandLineParser>
#include <QFileInfo>

using namespace dipwright;

namespace {

constexpr int moveInterval = 16;     // ms between two moves of the mouse
constexpr double turnOfMove = 0.2;   // degrees
constexpr int longestWait = 600'000; // ms

// Counts the pictures that the view has drawn.
class PictureCount {
public:
    explicit PictureCount(const DipView& view) : view_(view) {}
    void look() {
        const qint64 key = view_.shownPicture().cacheKey();
        count_ += key != std::exchange(last_, key) ? 1 : 0;
    }
    int count() const { return count_; }

private:
    const DipView& view_;
    qint64 last_ = 0;
    int count_ = 0;
};

// Turns the part by its ring about Y and releases it.
void drag(MainWindow& window, double seconds, double& turned) {
    DipView& view = window.view();
    PictureCount pictures(view);
    QSignalSpy drafts(&window.session(), &DipSession::shownChanged);
    bench::Heartbeat heart;
    heart.start();
    QElapsedTimer clock;
    clock.start();
    double angle = 0;
    while (double(clock.elapsed()) < 1000 * seconds) {
        angle += turnOfMove;
        emit view.rotationDragged(0, angle);
        QTest::qWait(moveInterval);
        pictures.look();
    }
    turned += angle;
    std::printf("dragging: %.1f drafts/s, %.1f pictures/s\n", drafts.count() / seconds,
                pictures.count() / seconds);
    heart.print("dragging");
}

void measure(MainWindow& window, const QString& name, double seconds, const QString& folder) {
    double turned = 0;
    drag(window, seconds, turned);
    QSignalSpy drafts(&window.session(), &DipSession::shownChanged);
    QSignalSpy finished(&window.session(), &DipSession::finished);
    bench::Heartbeat heart;
    heart.start();
    QElapsedTimer clock;
    clock.start();
    emit window.view().rotationDragged(0, turned + 3);
    emit window.view().rotationFinished();
    double first = 0;
    std::vector<int> due{100, 1000, 5000};
    while (finished.isEmpty() && clock.elapsed() < longestWait) {
        QTest::qWait(1);
        const bool isCurrent = window.session().freshness().dip;
        if (first == 0 && !drafts.isEmpty() && isCurrent) {
            first = double(clock.elapsed()) / 1000;
        }
        if (!folder.isEmpty() && !due.empty() && clock.elapsed() >= due.front()) {
            window.grab().save(QStringLiteral("%1/%2-%3ms.png").arg(folder, name).arg(due.front()));
            due.erase(due.begin());
        }
    }
    std::printf("first answer after %.3f s, result after %.2f s\n", first,
                double(clock.elapsed()) / 1000);
    heart.print("refining");
    if (!folder.isEmpty()) {
        QTest::qWait(500);
        window.grab().save(QStringLiteral("%1/%2-result.png").arg(folder, name));
    }
}

} // namespace

int main(int argc, char* argv[]) {
    const WindowApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addOptions(
        {{QStringLiteral("seconds"), {}, QStringLiteral("N"), QStringLiteral("10")},
         {QStringLiteral("size"), {}, QStringLiteral("WIDTHxHEIGHT"), QStringLiteral("1280x800")},
         {QStringLiteral("pictures"), {}, QStringLiteral("FOLDER")}});
    parser.addPositionalArgument(QStringLiteral("PROJECT"), {});
    parser.process(*qApp);
    const QStringList size = parser.value(QStringLiteral("size")).split(QLatin1Char('x'));
    for (const QString& path : parser.positionalArguments()) {
        Workbench workbench(application.home());
        MainWindow window(workbench);
        window.resize(size.value(0).toInt(), size.value(1).toInt());
        window.show();
        WindowDriver driver(window);
        const QString name = QFileInfo(path).completeBaseName();
        std::printf("%s\n", qPrintable(name));
        if (!driver.open(path) || !driver.run()) {
            std::fputs("The project could not be opened and run\n", stderr);
            return 1;
        }
        QTest::qWait(500);
        measure(window, name, parser.value(QStringLiteral("seconds")).toDouble(),
                parser.value(QStringLiteral("pictures")));
        window.document()->markUnmodified();
    }
    return 0;
}
