// The one exception that reaches the user: what is wrong, where, and what to do about it.
#pragma once

#include <QString>
#include <stdexcept>

namespace dipwright {

// `what`: one sentence without a full stop that names the fault and the remedy.
// `where`: the file, field or module it is about. Shown as "error: <what> (<where>)".
class Error : public std::runtime_error {
public:
    Error(const QString& what, const QString& where);
    const QString& message() const { return message_; }
    const QString& where() const { return where_; }
    // "<what> (<where>)", or just "<what>" without a where.
    QString sentence() const;

private:
    QString message_;
    QString where_;
};

} // namespace dipwright
