// The only exception type that is shown to the user. It says what is wrong, where, and what to do.
#pragma once

#include <QString>
#include <stdexcept>

namespace dipwright {

// `what` is one sentence, without a full stop, that names the fault and the remedy. `where` is the
// file, field or module that has the fault. The user sees "error: <what> (<where>)".
class Error : public std::runtime_error {
public:
    Error(const QString& what, const QString& where);
    const QString& message() const { return message_; }
    const QString& where() const { return where_; }
    // Returns "<what> (<where>)", or just "<what>" if `where` is empty.
    QString sentence() const;

private:
    QString message_;
    QString where_;
};

} // namespace dipwright
