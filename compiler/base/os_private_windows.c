// SPDX-License-Identifier: Apache-2.0
// Secrets, for os.h on Windows: random bytes for a key, and files that only this user can read.  The permissions of a file are an access
// control list; the system and the administrators can read every file, so they do not count as other users.
#include "compiler/base/os_files.h"
#include "compiler/base/os_windows.h"

#include <aclapi.h>
#include <stdlib.h>

bool os_get_random_bytes(void *bytes, size_t n, const char **why)
{
    *why = "there are too few random numbers";
    return SystemFunction036(bytes, (ULONG)n);
}

// Returns information about this user, on the heap; NULL if that fails.
static TOKEN_USER *current_user(void)
{
    TOKEN_USER *user = NULL;
    HANDLE token;
    DWORD n = 0;

    if (!OpenProcessToken(GetCurrentProcess(), TOKEN_QUERY, &token))
        return NULL;
    GetTokenInformation(token, TokenUser, NULL, 0, &n);
    if (n && (user = malloc(n)) != NULL && !GetTokenInformation(token, TokenUser, user, n, &n)) {
        free(user);
        user = NULL;
    }
    CloseHandle(token);
    return user;
}

bool windows_private_security(SECURITY_ATTRIBUTES *attributes, SECURITY_DESCRIPTOR *descriptor, ACL **acl)
{
    TOKEN_USER *user = current_user();
    const DWORD n = user ? (DWORD)(sizeof(ACL) + sizeof(ACCESS_ALLOWED_ACE)) + GetLengthSid(user->User.Sid) : 0;
    const bool ok = user && (*acl = LocalAlloc(LPTR, n)) != NULL && InitializeAcl(*acl, n, ACL_REVISION) &&
                    AddAccessAllowedAceEx(*acl, ACL_REVISION, OBJECT_INHERIT_ACE | CONTAINER_INHERIT_ACE, GENERIC_ALL, user->User.Sid) &&
                    InitializeSecurityDescriptor(descriptor, SECURITY_DESCRIPTOR_REVISION) &&
                    SetSecurityDescriptorDacl(descriptor, TRUE, *acl, FALSE) &&
                    SetSecurityDescriptorControl(descriptor, SE_DACL_PROTECTED, SE_DACL_PROTECTED);

    free(user);
    attributes->nLength = sizeof *attributes;
    attributes->lpSecurityDescriptor = descriptor;
    attributes->bInheritHandle = FALSE;
    return ok;
}

bool os_write_private(const char *path, const void *bytes, size_t n, const char **why)
{
    SECURITY_ATTRIBUTES security;
    SECURITY_DESCRIPTOR descriptor;
    ACL *acl = NULL;
    HANDLE file;
    bool ok;

    if (!windows_check_name(path, why))
        return false;
    if (!windows_private_security(&security, &descriptor, &acl)) {
        LocalFree(acl);
        *why = "its permissions cannot be set";
        return false;
    }
    file = windows_create_new(path, &security, why);
    LocalFree(acl);
    if (file == INVALID_HANDLE_VALUE)
        return false;
    ok = windows_write_all(file, bytes, n, why);
    if (!CloseHandle(file) && ok)
        ok = windows_set_reason(why);
    if (!ok)
        os_remove_file(path);
    return ok;
}

// Whether `sid` is a user other than the owner. The system and the administrators do not count, because they can read every file.
static bool is_other_user(PSID sid, PSID owner)
{
    return !EqualSid(sid, owner) && !IsWellKnownSid(sid, WinLocalSystemSid) && !IsWellKnownSid(sid, WinBuiltinAdministratorsSid) &&
           !IsWellKnownSid(sid, WinCreatorOwnerSid) && !IsWellKnownSid(sid, WinCreatorOwnerRightsSid);
}

// Whether a list of access rights allows any user but the owner and the system to read the file.
static bool others_can_read(ACL *acl, PSID owner)
{
    const DWORD reads = FILE_READ_DATA | GENERIC_READ | GENERIC_ALL;

    for (DWORD i = 0; acl && i < acl->AceCount; i++) {
        ACCESS_ALLOWED_ACE *ace;
        if (GetAce(acl, i, (void **)&ace) && ace->Header.AceType == ACCESS_ALLOWED_ACE_TYPE && (ace->Mask & reads) &&
            is_other_user((PSID)&ace->SidStart, owner))
            return true;
    }
    return acl == NULL;
}

bool os_is_private(const char *path)
{
    wchar_t *wide = windows_path(path);
    PSECURITY_DESCRIPTOR descriptor = NULL;
    PSID owner = NULL;
    ACL *acl = NULL;
    const DWORD error = wide ? GetNamedSecurityInfoW(wide, SE_FILE_OBJECT, OWNER_SECURITY_INFORMATION | DACL_SECURITY_INFORMATION, &owner, NULL, &acl,
                                                     NULL,
                                                     &descriptor)
                             : ERROR_NOT_ENOUGH_MEMORY;
    const bool is_private = error != 0 || !others_can_read(acl, owner);

    LocalFree(descriptor);
    free(wide);
    return is_private;
}
