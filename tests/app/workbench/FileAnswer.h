// Answers a dialog for a file or folder, like a user who types its name.
#pragma once

#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>

namespace dipwright {

// Answers with `path` as soon as the dialog is open. Returns at once.
inline void answerWithFile(const QString& path) {
    auto* timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, qApp, [timer, path] {
        if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
            timer->deleteLater();
            dialog->findChild<QLineEdit*>()->setText(path);
            dialog->findChild<QPushButton*>()->click();
        }
    });
    timer->start(50);
}

} // namespace dipwright
