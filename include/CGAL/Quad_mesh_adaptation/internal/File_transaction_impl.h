// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_TRANSACTION_IMPL_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_TRANSACTION_IMPL_H

#include <CGAL/Quad_mesh_adaptation/IO/File_transaction.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <system_error>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Puts the file that symbolic links lead to in place of theirs, be it there or not; `false` where
// they go round in circles.
inline bool follow_links(std::filesystem::path& file)
{
  constexpr int most = 40; // of one after the other, as in Linux
  std::error_code error;
  for(int i = 0; i < most; ++i) {
    if(!std::filesystem::is_symlink(std::filesystem::symlink_status(file, error))) return true;
    const std::filesystem::path next = std::filesystem::read_symlink(file, error);
    if(error) return false;
    file = file.parent_path() / next; // just `next` where that is absolute
  }
  return false;
}

} // namespace internal

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL File_transaction::~File_transaction()
{
  std::error_code ignored;
  for(const Staged_file& file : files_) std::filesystem::remove(file.temporary, ignored);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Write_result
File_transaction::stage(const std::string& target, const std::string& contents)
{
  Staged_file file;
  Write_result result = choose_names(target, file);
  if(!result.ok()) return result;
  for(const Staged_file& other : files_)
    if(other.target == file.target) return refuse(target, "another output has the same name");
  std::ofstream stream(file.temporary, std::ios::binary);
  if(!stream) return refuse(target, "its folder does not exist or cannot be written to");
  files_.push_back(file);
  std::error_code no_such_file;
  const auto permissions = std::filesystem::status(file.target, no_such_file).permissions();
  if(permissions != std::filesystem::perms::unknown && !no_such_file)
    std::filesystem::permissions(file.temporary, permissions, no_such_file);
  stream.write(contents.data(), static_cast<std::streamsize>(contents.size()));
  stream.close();
  if(!stream) return refuse(target, "writing failed, perhaps the disk is full");
  return {};
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Write_result File_transaction::commit()
{
  while(!files_.empty()) {
    std::error_code error;
    std::filesystem::rename(files_.front().temporary, files_.front().target, error);
    if(error) return refuse(files_.front().target.string(), error.message());
    files_.erase(files_.begin());
  }
  return {};
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Write_result File_transaction::probe(const std::string& target)
{
  File_transaction trial;
  return trial.stage(target, "");
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Write_result File_transaction::refuse(const std::string& target,
                                                                          const std::string& why)
{
  return { Refusal::unwritable_file, target + ": cannot be written: " + why };
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Write_result
File_transaction::choose_names(const std::string& target, Staged_file& file)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(target, error);
  file.target = target;
  if(std::filesystem::exists(status)) {
    if(!std::filesystem::is_regular_file(status)) return refuse(target, "it is no regular file");
    // a file that its owner protects is not to be replaced, though its folder would allow it
    if(!std::ofstream(target, std::ios::binary | std::ios::app))
      return refuse(target, "it exists and may not be changed");
    file.target = std::filesystem::canonical(target, error);
    if(error) return refuse(target, error.message());
  } else {
    if(!internal::follow_links(file.target))
      return refuse(target, "its symbolic links go in a circle");
    // the same for all names of a file, like that of one which is there
    const auto name =
        std::filesystem::weakly_canonical(std::filesystem::absolute(file.target, error), error);
    if(!error) file.target = name;
  }
  std::random_device random;
  do {
    file.temporary = file.target;
    file.temporary += "." + std::to_string(random()) + ".part";
  } while(std::filesystem::exists(file.temporary, error));
  return {};
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_TRANSACTION_IMPL_H
