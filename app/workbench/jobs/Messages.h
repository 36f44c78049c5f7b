// Carries the messages of one window's jobs to the user. The window decides how the messages are
// shown.
#pragma once

#include <QObject>
#include <QStringList>
#include <exception>
#include <functional>

namespace dipwright {

// The message of `failure` for the user.
QString sentenceOf(const std::exception_ptr& failure);

class Messages : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void log(const QString& line) { emit logged(line); }
    // Shows a sentence for a while; 0 milliseconds: until the next one.
    void say(const QString& sentence, int milliseconds = 8000) {
        emit said(sentence, milliseconds);
    }
    void logAndSay(const QString& sentence);
    void notice(const QString& text) { emit noticed(text); }
    void inform(const QString& text) { emit informed(text); }
    void fail(const QString& title, const std::exception_ptr& failure);
    // Asks whether these files may be read. `who` is a sentence that says who names them and ends
    // in a colon. `allowed` is called later if the user agrees.
    void askToRead(const QString& title, const QString& who, const QStringList& files,
                   const std::function<void()>& allowed) {
        emit askedToRead(title, who, files, allowed);
    }

signals:
    void logged(const QString& line); // stored in the log
    void said(const QString& sentence, int milliseconds);
    // A warning, shown until it is closed; empty: closes the last one.
    void noticed(const QString& text);
    void informed(const QString& text); // a remark, shown until it is closed
    void failed(const QString& title, const QString& sentence);
    void askedToRead(const QString& title, const QString& who, const QStringList& files,
                     const std::function<void()>& allowed);
};

} // namespace dipwright
