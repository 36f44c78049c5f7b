// Writes text without control characters, so that file names and plugins cannot control the
// terminal.
#pragma once

#include <QFile>
#include <cstdio>

namespace dipwright::cli {

// Writes to `file`. Removes all control characters except line ends and tabs.
class PlainOutput : public QIODevice {
public:
    explicit PlainOutput(std::FILE* file);

protected:
    qint64 readData(char* bytes, qint64 size) override;
    qint64 writeData(const char* bytes, qint64 size) override;

private:
    QFile file_;
};

} // namespace dipwright::cli
