// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_IO_FILE_TRANSACTION_H
#define CGAL_QUAD_MESH_ADAPTATION_IO_FILE_TRANSACTION_H

#include <CGAL/Quad_mesh_adaptation/Refusal.h>
#include <CGAL/Quad_mesh_adaptation/internal/compiled_core.h>

#include <filesystem>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// How writing a file ended.
struct Write_result
{
  Refusal reason = Refusal::none; ///< `none` or `unwritable_file`
  std::string message;            ///< one sentence for a person, without a final full stop

  bool ok() const { return reason == Refusal::none; }
};

/// Writes files all or nothing: each is first written beside its target under another name, and
/// only `commit()` gives them their names.  What is not committed is removed by the destructor, so
/// no failure of a call or of the disk leaves a half-written file or loses an old one.  That does
/// not hold for a loss of power: nothing is forced onto the disk.
class File_transaction
{
public:
  File_transaction() = default;
  File_transaction(const File_transaction&) = delete;
  File_transaction& operator=(const File_transaction&) = delete;
  ~File_transaction();

  /// Writes `contents` beside `target`, which stays as it is.  A symbolic link is followed, also
  /// to a file that is not there yet.  A target that is staged already is refused.
  Write_result stage(const std::string& target, const std::string& contents);

  /// Gives every staged file its name, replacing what had it.  Stops at the first that fails; only
  /// then can some files be in place and others not.
  Write_result commit();

  /// Whether `stage()` would find a place to write `target`; leaves nothing behind.
  static Write_result probe(const std::string& target);

private:
  struct Staged_file
  {
    std::filesystem::path target, temporary;
  };

  static Write_result refuse(const std::string& target, const std::string& why);

  static Write_result choose_names(const std::string& target, Staged_file& file);

  std::vector<Staged_file> files_;
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#ifndef QUAD_MESH_ADAPTATION_COMPILED_CORE
#include <CGAL/Quad_mesh_adaptation/internal/File_transaction_impl.h>
#endif

#endif // CGAL_QUAD_MESH_ADAPTATION_IO_FILE_TRANSACTION_H
