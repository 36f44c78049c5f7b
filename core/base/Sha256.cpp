#include "base/Sha256.h"

#include <openssl/evp.h>

#include <new>

namespace dipwright {
namespace {

// OpenSSL fails here only when memory runs out.
void require(bool success) {
    if (!success) {
        throw std::bad_alloc();
    }
}

} // namespace

Sha256::Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    require(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
}

void Sha256::add(QByteArrayView bytes) {
    require(EVP_DigestUpdate(context_.get(), bytes.data(), std::size_t(bytes.size())) == 1);
}

QByteArray Sha256::result() {
    QByteArray hash(EVP_MD_size(EVP_sha256()), '\0');
    auto* bytes = reinterpret_cast<unsigned char*>(hash.data());
    require(EVP_DigestFinal_ex(context_.get(), bytes, nullptr) == 1);
    return hash;
}

QByteArray sha256(QByteArrayView bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.result();
}

QString sha256Hex(QByteArrayView bytes) {
    return QString::fromLatin1(sha256(bytes).toHex());
}

} // namespace dipwright
