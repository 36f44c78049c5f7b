#include "WindowDriver.h"

#include "Patience.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QMouseEvent>

namespace dipwright {

WindowApplication::WindowApplication(int& argc, char** argv) {
    const QByteArray home = home_.path().toLocal8Bit();
    for (const char* variable :
         {"HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_RUNTIME_DIR"}) {
        qputenv(variable, home);
    }
    qputenv("LC_ALL", "C.UTF-8");
    application_ = std::make_unique<QApplication>(argc, argv);
    QApplication::setApplicationName(QStringLiteral("dipwright"));
    QApplication::setOrganizationName(QStringLiteral("Dipwright"));
    Preferences preferences = loadPreferences();
    preferences.keepsResults = false; // leaves no files beside the samples
    savePreferences(preferences);
}

bool WindowDriver::open(const QString& path) {
    QSignalSpy opened(&window_.documents(), &DocumentSession::documentChanged);
    window_.documents().openProject(path);
    return opened.wait(patience());
}

bool WindowDriver::create(const QString& model, const QString& texture, double longestEdge,
                          const std::function<void(Project&)>& complete) {
    ImportOptions options;
    options.longestEdge = Millimetres(longestEdge);
    options.texture = texture;
    QSignalSpy opened(&window_.documents(), &DocumentSession::documentChanged);
    window_.documents().importModel(model, options, complete);
    return opened.wait(patience());
}

bool WindowDriver::run() {
    QSignalSpy finished(&window_.session(), &DipSession::finished);
    QSignalSpy stopped(&window_.session(), &DipSession::stopped);
    trigger("run");
    const auto ended = [&] { return !finished.isEmpty() || !stopped.isEmpty(); };
    return QTest::qWaitFor(ended, patience()) && !finished.isEmpty();
}

bool WindowDriver::save() {
    window_.documents().save();
    return waitForSave();
}

bool WindowDriver::saveAs(const QString& path) {
    window_.documents().saveAs(path);
    return waitForSave();
}

bool WindowDriver::waitForSave() {
    return QTest::qWaitFor([this] { return !window_.documents().isSaving(); }, patience()) &&
           !window_.document()->isModified();
}

void WindowDriver::drop(const QString& path) const {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window_, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window_, &drop);
}

QAction* WindowDriver::action(const char* name) const {
    return window_.findChild<QAction*>(QLatin1String(name));
}

void makeCoarse(Project& project) {
    project.film.resolution = FilmResolution::Points;
    project.film.columns = 28;
    project.film.rows = 40;
    project.fieldResolution = 64;
    project.sheet.resolution = DotsPerInch(72);
}

void WindowDriver::drag(QWidget& widget, QPointF from, QPointF to) {
    constexpr int steps = 12;
    const auto at = [&](double share) {
        const QPointF place = from + share * (to - from);
        return QPoint(int(place.x() * widget.width()), int(place.y() * widget.height()));
    };
    QTest::mousePress(&widget, Qt::LeftButton, {}, at(0));
    for (int step = 1; step <= steps; ++step) {
        // QTest::mouseMove cannot move with a pressed button.
        const QPointF place = at(double(step) / steps);
        QMouseEvent move(QEvent::MouseMove, place, widget.mapToGlobal(place), Qt::NoButton,
                         Qt::LeftButton, {});
        QApplication::sendEvent(&widget, &move);
    }
    QTest::mouseRelease(&widget, Qt::LeftButton, {}, at(1));
}

} // namespace dipwright
