#include "workbench/jobs/Messages.h"

#include "base/Error.h"

namespace dipwright {

QString sentenceOf(const std::exception_ptr& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        return error.sentence();
    } catch (const std::exception& error) {
        return QString::fromUtf8(error.what());
    }
}

void Messages::logAndSay(const QString& sentence) {
    log(sentence);
    say(sentence);
}

void Messages::fail(const QString& title, const std::exception_ptr& failure) {
    const QString sentence = sentenceOf(failure);
    log(sentence);
    emit failed(title, sentence);
}

} // namespace dipwright
