// What this program and the process that reads foreign files (dipwright-reader) tell each other.
//   to the reader:   one job, then an answer to each file that it asks for
//   from the reader: files asked for, progress, and at the end either what was read or a failure
// A message is its kind (u8), the length of what follows (u64, little-endian), and that.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QStringList>

namespace dipwright {

enum class ReaderMessage : quint8 {
    Job = 1,  // ReaderJob
    File,     // the content of the file asked for
    NoFile,   // it is not there or may not be read
    Ask,      // name of a file, UTF-8
    Progress, // share (double), text
    Photo,    // what a photo says of itself (PhotoFacts); then, as a message of its own kind, it
    Picture,  // width, height (i32), dots per metre of both, wide (i32), colour note: assumed inks
              // (i32), share that was clipped (double); rows without gaps
    Model,    // warnings; then, as a message of its own kind, the mesh
    Mesh,     // as StoredModel has it
    Failed    // message and place, for an Error
};

constexpr qint64 readerHeaderBytes = 9;

struct ReaderJob {
    enum class Kind : quint8 { Model, Pictures, Photos };
    Kind kind = Kind::Model;
    QStringList names;        // of the model file, or what the user knows each picture by
    bool withTextures = true; // of a model
    QString language;         // "de", in which failures are told; empty: English
};

// What a camera writes into a photo (EXIF 2.3).
struct PhotoFacts {
    QString taken; // "2026:11:22 14:03:07" as the camera's clock had it; empty: it says nothing
    double focalLength = 0; // mm, as of a lens for pictures of 36 × 24 mm; 0: it says nothing
};

// Exit codes of the reader that has no time to say more.
constexpr int readerOutOfTime = 3;

QByteArray headerBytes(ReaderMessage kind, qint64 length);
// Nothing is taken for granted of what came: kind and length are as sent.
std::pair<ReaderMessage, qint64> readHeader(const QByteArray& header);

QByteArray jobBytes(const ReaderJob& job);
ReaderJob readJob(const QByteArray& bytes);

QByteArray factsBytes(const PhotoFacts& facts);
PhotoFacts readFacts(const QByteArray& bytes);

// The part of a picture's message before its pixels.
QByteArray pictureHeaderBytes(const QImage& picture);
constexpr qint64 pictureHeaderLength = 32;
// A picture of that size to be filled; null where there is none or no memory for it. Throws
// nothing.
QImage emptyPicture(const QByteArray& header);

} // namespace dipwright
