// Fuzzes the reader of one model format. The bytes after a line of "====" are the content of every
// file that the model names.
#include "base/Error.h"
#include "import/sandboxed/UntrustedModel.h"

namespace {

class Given : public dipwright::UntrustedFiles {
public:
    explicit Given(const QByteArray& bytes) {
        const QByteArray line = "\n====\n";
        const auto end = bytes.indexOf(line);
        model_ = end < 0 ? bytes : bytes.left(end);
        named_ = end < 0 ? QByteArray() : bytes.mid(end + line.size());
    }

private:
    std::optional<QByteArray> fetch(const QString& name) override {
        return name == QStringLiteral("fuzz." DIPWRIGHT_FUZZED_FORMAT) ? model_ : named_;
    }
    QByteArray model_, named_;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    Given files(QByteArray(reinterpret_cast<const char*>(data), qsizetype(size)));
    try {
        dipwright::readUntrustedModel(QStringLiteral("fuzz." DIPWRIGHT_FUZZED_FORMAT), files, true,
                                      {});
    } catch (const dipwright::Error&) {
    }
    return 0;
}
