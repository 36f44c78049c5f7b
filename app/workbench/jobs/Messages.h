// What the work of one window has to tell its user. How that is shown is the window's affair.
#pragma once

#include <QObject>
#include <QStringList>
#include <exception>
#include <functional>

namespace dipwright {

// What `failure` says to the user.
QString sentenceOf(const std::exception_ptr& failure);

class Messages : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void log(const QString& line) { emit logged(line); }
    // For a while; 0 milliseconds: until something else is said.
    void say(const QString& sentence, int milliseconds = 8000) {
        emit said(sentence, milliseconds);
    }
    void logAndSay(const QString& sentence);
    void notice(const QString& text) { emit noticed(text); }
    void fail(const QString& title, const std::exception_ptr& failure);
    // Whether these files may be read; `who`: who names them, in a sentence that ends in a colon.
    // `allowed` is called if so, later.
    void askToRead(const QString& title, const QString& who, const QStringList& files,
                   const std::function<void()>& allowed) {
        emit askedToRead(title, who, files, allowed);
    }

signals:
    void logged(const QString& line); // kept, for who looks it up
    void said(const QString& sentence, int milliseconds);
    void noticed(const QString& text); // to be read and closed; empty: the last one is over
    void failed(const QString& title, const QString& sentence);
    void askedToRead(const QString& title, const QString& who, const QStringList& files,
                     const std::function<void()>& allowed);
};

} // namespace dipwright
