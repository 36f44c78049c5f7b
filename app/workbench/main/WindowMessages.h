// Shows what the work of a window tells its user: in the log, in the status bar, in the bar over
// the view, and what has failed or is to be decided in a box.
#pragma once

#include <QObject>
#include <functional>

class QMainWindow;

namespace dipwright {

class Messages;
struct WindowParts;

class WindowMessages : public QObject {
    Q_OBJECT

public:
    WindowMessages(const Messages& messages, const WindowParts& parts, QMainWindow& window);

private:
    void showFailure(const QString& title, const QString& sentence);
    void askToRead(const QString& title, const QString& who, const QStringList& files,
                   const std::function<void()>& allowed);

    QMainWindow& window_;
};

} // namespace dipwright
