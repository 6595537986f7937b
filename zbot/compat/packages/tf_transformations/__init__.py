"""ROS 2's `tf_transformations`: rotations and matrices. It needs numpy and transforms3d."""

try:
    from zbot.tf2.affine import (
        clip_matrix,
        orthogonalization_matrix,
        projection_from_matrix,
        projection_matrix,
        random_vector,
        reflection_from_matrix,
        reflection_matrix,
        rotation_from_matrix,
        scale_from_matrix,
        shear_from_matrix,
        shear_matrix,
        superimposition_matrix,
    )
    from zbot.tf2.arcball import (
        Arcball,
        arcball_constrain_to_axis,
        arcball_map_to_sphere,
        arcball_nearest_axis,
    )
    from zbot.tf2.transformations import (
        ROTATION_IDENTITY,
        SHEAR_IDENTITY,
        TRANSLATION_IDENTITY,
        ZOOM_IDENTITY,
        compose_matrix,
        concatenate_matrices,
        decompose_matrix,
        euler_from_matrix,
        euler_from_quaternion,
        euler_matrix,
        identity_matrix,
        inverse_matrix,
        is_same_transform,
        quaternion_about_axis,
        quaternion_conjugate,
        quaternion_from_euler,
        quaternion_from_matrix,
        quaternion_inverse,
        quaternion_matrix,
        quaternion_multiply,
        quaternion_slerp,
        random_quaternion,
        random_rotation_matrix,
        rotation_matrix,
        scale_matrix,
        translation_from_matrix,
        translation_matrix,
        unit_vector,
        vector_norm,
    )
except ModuleNotFoundError as error:
    from zbot.tf2.errors import NoTransforms3dError

    if error.name not in {"numpy", "transforms3d"}:
        raise
    raise NoTransforms3dError(error.name) from None
