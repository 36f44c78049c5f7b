// Text for a terminal, whoever has written it.
#pragma once

#include <QFile>
#include <cstdio>

namespace dipwright::cli {

// Writes to `file`, but for control characters other than the ends of lines and tabulators: names
// come from files and plugins, and a terminal would do what they say.
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
