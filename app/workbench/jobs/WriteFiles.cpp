#include "workbench/jobs/WriteFiles.h"

#include "workbench/jobs/StartJob.h"

#include <QDir>

namespace dipwright {

void writeFiles(JobRunner& jobs, Messages& messages, const QString& title, const QString& done,
                const QString& path, const WriteFile& write) {
    startJob(
        jobs, messages, title, title,
        [write, path](const Progress& progress) {
            write(path, progress);
            return true;
        },
        [&messages, sentence = done.arg(QDir::toNativeSeparators(path))](bool) {
            messages.logAndSay(sentence);
        });
}

} // namespace dipwright
