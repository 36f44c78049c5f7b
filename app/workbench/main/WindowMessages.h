// Shows the messages of a window's work in the log, the status bar and the bar over the view.
// Failures and questions appear in a box.
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
