// SHA-256, by OpenSSL, which asks the processor's own instructions for it: ten times as fast as
// Qt's, and sheets have tens of megabytes.
#pragma once

#include <QByteArray>
#include <QByteArrayView>
#include <QString>

#include <memory>

struct evp_md_ctx_st; // OpenSSL's

namespace dipwright {

// Of bytes that come piece by piece.
class Sha256 {
public:
    Sha256();

    void add(QByteArrayView bytes);
    // The 32 bytes of the hash; once, nothing can be added after it.
    QByteArray result();

private:
    std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

// The 32 bytes of the hash.
QByteArray sha256(QByteArrayView bytes);
// The same as 64 small letters and digits.
QString sha256Hex(QByteArrayView bytes);

} // namespace dipwright
